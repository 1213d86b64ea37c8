// SPDX-License-Identifier: Apache-2.0
// The error rules of docs/command-stream.md.
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/frame/codec.hpp>
#include <gnomon/golden/topology/codec.hpp>

namespace gnomon::golden {
namespace {

/// Flag bits with a meaning; nothing where the op does not exist.
std::optional<std::uint8_t> known_flags(std::uint8_t op) {
  switch (static_cast<Op>(op)) {
    case Op::Fence:
      return kFenceClearSticky;
    case Op::ResolveVoxels:
      return kResolveTwoSided;
    case Op::Nop:
    case Op::SetRegisters:
    case Op::ClearPlane:
    case Op::ReadPlane:
    case Op::ProjectVoxels:
      return std::uint8_t{0};
  }
  return std::nullopt;
}

/// The two commands whose states a frame buffer can keep.
bool is_resolve(const Header& header) {
  return header.op == static_cast<std::uint8_t>(Op::ResolveVoxels) ||
         header.op == static_cast<std::uint8_t>(topology::TopologyOp::ResolveTopology);
}

bool bad_argument(const Header& header, const HardwareConfig& config) {
  switch (static_cast<Op>(header.op)) {
    case Op::ClearPlane:
    case Op::Fence:
      return header.count != 0;
    case Op::ReadPlane: {
      const PlaneRange range = decode_plane_range(header.arg);
      const std::uint32_t entries = std::uint32_t{1} << (2 * config.plane_log2);
      return header.count != 0 || range.first + range.count > entries;
    }
    default:
      return false;
  }
}

/// Errors of the command processor and the projection unit.
std::optional<ErrorCode> vpu_error(const Header& header, const HardwareConfig& config) {
  const auto flags = known_flags(header.op);
  if (!flags) return ErrorCode::UnknownOp;
  if ((header.flags & ~*flags) != 0) return ErrorCode::ReservedFlag;
  const Op op = static_cast<Op>(header.op);
  if (op == Op::ResolveVoxels && !config.en_vpu_offset) return ErrorCode::FeatureAbsent;
  const std::int64_t register_end = std::int64_t{header.arg} + header.count;
  if (op == Op::SetRegisters && register_end > register_count(config)) {
    return register_end > kAllRegisterCount ? ErrorCode::BadRegister : ErrorCode::FeatureAbsent;
  }
  if (bad_argument(header, config)) return ErrorCode::BadArgument;
  return std::nullopt;
}

}  // namespace

std::optional<ErrorCode> CommandSequence::slb_error(const Header& header) const {
  const auto op = static_cast<slb::SlbOp>(header.op);
  if ((header.flags & ~slb::known_flags(op)) != 0) return ErrorCode::ReservedFlag;
  if (!config_.en_slb) return ErrorCode::FeatureAbsent;
  if (slb::bad_argument(op, header.arg, header.count, config_.slb_config())) return ErrorCode::BadArgument;
  if (!slb_.allows(op)) return ErrorCode::BadSequence;
  return std::nullopt;
}

std::optional<ErrorCode> CommandSequence::topology_error(const Header& header) const {
  const auto op = static_cast<topology::TopologyOp>(header.op);
  if ((header.flags & ~topology::known_flags(op)) != 0) return ErrorCode::ReservedFlag;
  if (!config_.en_vpu_topology) return ErrorCode::FeatureAbsent;
  const bool bad = topology::bad_argument(op, header.arg, header.count, config_.topology_config());
  return bad ? std::optional(ErrorCode::BadArgument) : std::nullopt;
}

std::optional<ErrorCode> CommandSequence::frame_error(const Header& header) const {
  const auto op = static_cast<frame::FrameOp>(header.op);
  if ((header.flags & ~frame::known_flags(op)) != 0) return ErrorCode::ReservedFlag;
  if (!config_.en_frame_buffer) return ErrorCode::FeatureAbsent;
  const bool bad = frame::bad_argument(op, header.arg, header.count, config_.frame_config());
  return bad ? std::optional(ErrorCode::BadArgument) : std::nullopt;
}

/// Of a resolve command with one of the frame buffer's flags.
std::optional<ErrorCode> CommandSequence::resolve_error(Header header) const {
  const bool keep = (header.flags & frame::kKeep) != 0;
  header.flags &= static_cast<std::uint8_t>(~frame::kResolveFlags);
  const auto error = error_without_frame(header);
  if (error == ErrorCode::ReservedFlag || error == ErrorCode::FeatureAbsent) return error;
  if (!config_.en_frame_buffer) return ErrorCode::FeatureAbsent;
  if (error) return error;
  const bool bad = keep && frame::decode_layer(header.arg) >= config_.frame_config().layers();
  return bad ? std::optional(ErrorCode::BadArgument) : std::nullopt;
}

std::optional<ErrorCode> CommandSequence::error_without_frame(const Header& header) const {
  return topology::is_topology_op(header.op) ? topology_error(header) : vpu_error(header, config_);
}

std::optional<ErrorCode> CommandSequence::next(const Header& header) {
  if (frame::is_frame_op(header.op)) return frame_error(header);
  if (is_resolve(header) && (header.flags & frame::kResolveFlags) != 0) return resolve_error(header);
  if (!slb::is_slb_op(header.op)) return error_without_frame(header);
  const auto error = slb_error(header);
  if (!error) slb_.advance(static_cast<slb::SlbOp>(header.op), header.flags);
  return error;
}

std::uint32_t result_count(const Header& header, std::optional<ErrorCode> error,
                           const HardwareConfig& config) {
  if (error) return 1;
  if (is_resolve(header) && (header.flags & frame::kQuiet) != 0) return 0;
  if (frame::is_frame_op(header.op))
    return frame::result_words(static_cast<frame::FrameOp>(header.op), header.flags, header.count);
  if (slb::is_slb_op(header.op)) {
    return slb::result_words(static_cast<slb::SlbOp>(header.op), header.arg, header.count,
                             config.slb_config());
  }
  if (topology::is_topology_op(header.op))
    return topology::result_words(static_cast<topology::TopologyOp>(header.op), header.arg, header.count);
  switch (static_cast<Op>(header.op)) {
    case Op::Fence:
      return 1;
    case Op::ReadPlane:
      return decode_plane_range(header.arg).count;
    case Op::ResolveVoxels:
      return header.count;
    default:
      return 0;
  }
}

std::uint32_t encode(const PlaneRange& range) {
  return ((range.count - 1) & 0xFF) << 24 | (range.first & 0xFFFFFF);
}

PlaneRange decode_plane_range(std::uint32_t arg) {
  return {.first = arg & 0xFFFFFF, .count = (arg >> 24) + 1};
}

}  // namespace gnomon::golden
