// SPDX-License-Identifier: Apache-2.0
// Words as one line of text, for mismatch reports and logs.
#include <cstdio>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/frame/codec.hpp>
#include <gnomon/golden/slb/sequence.hpp>
#include <gnomon/golden/topology/codec.hpp>

namespace gnomon::golden {
namespace {

std::string hex(Word value, int digits) {
  char text[24];
  std::snprintf(text, sizeof text, "0x%0*llX", digits, static_cast<unsigned long long>(value));
  return text;
}

std::string depth_text(std::uint32_t depth) {
  return depth == 0xFFFFFF ? "none" : std::to_string(depth);
}

std::string slb_op_name(slb::SlbOp op) {
  switch (op) {
    case slb::SlbOp::Clear:
      return "SLB_CLEAR";
    case slb::SlbOp::BeginObject:
      return "BEGIN_OBJECT";
    case slb::SlbOp::Loop:
      return "LOOP";
    case slb::SlbOp::Fill:
      return "FILL";
    case slb::SlbOp::Cover:
      return "COVER";
    case slb::SlbOp::EndObject:
      return "END_OBJECT";
    case slb::SlbOp::Query:
      return "QUERY";
    case slb::SlbOp::ReadEntries:
      return "READ_ENTRIES";
  }
  return "";
}

std::string topology_op_name(topology::TopologyOp op) {
  switch (op) {
    case topology::TopologyOp::ClearLists:
      return "CLEAR_LISTS";
    case topology::TopologyOp::PutQuads:
      return "PUT_QUADS";
    case topology::TopologyOp::ResolveTopology:
      return "RESOLVE_TOPOLOGY";
    case topology::TopologyOp::ReadLists:
      return "READ_LISTS";
  }
  return "";
}

std::string op_name(std::uint8_t op) {
  if (frame::is_frame_op(op))
    return op == static_cast<std::uint8_t>(frame::FrameOp::ClearFrame) ? "CLEAR_FRAME" : "LOOKUP_FRAME";
  if (topology::is_topology_op(op)) return topology_op_name(static_cast<topology::TopologyOp>(op));
  if (slb::is_slb_op(op)) return slb_op_name(static_cast<slb::SlbOp>(op));
  switch (static_cast<Op>(op)) {
    case Op::Nop:
      return "NOP";
    case Op::SetRegisters:
      return "SET_REGISTERS";
    case Op::ClearPlane:
      return "CLEAR_PLANE";
    case Op::Fence:
      return "FENCE";
    case Op::ReadPlane:
      return "READ_PLANE";
    case Op::ProjectVoxels:
      return "PROJECT_VOXELS";
    case Op::ResolveVoxels:
      return "RESOLVE_VOXELS";
  }
  return "unknown op " + hex(op, 2);
}

std::string error_name(std::uint8_t error) {
  switch (static_cast<ErrorCode>(error)) {
    case ErrorCode::UnknownOp:
      return "UNKNOWN_OP";
    case ErrorCode::FeatureAbsent:
      return "FEATURE_ABSENT";
    case ErrorCode::BadRegister:
      return "BAD_REGISTER";
    case ErrorCode::BadArgument:
      return "BAD_ARGUMENT";
    case ErrorCode::ReservedFlag:
      return "RESERVED_FLAG";
    case ErrorCode::BadSequence:
      return "BAD_SEQUENCE";
  }
  return "unknown error " + std::to_string(error);
}

std::string state_name(VoxelState state) {
  switch (state) {
    case VoxelState::Empty:
      return "empty";
    case VoxelState::Lit:
      return "lit";
    case VoxelState::Shadow:
      return "shadow";
  }
  return "state 3";
}

std::string sticky_text(std::uint32_t sticky) {
  std::string names;
  const auto add = [&](std::uint32_t bit, const char* name) {
    if ((sticky & bit) == 0) return;
    if (!names.empty()) names += "|";
    names += name;
  };
  add(kStickyErrorSeen, "ERROR_SEEN");
  add(kStickyOffPlane, "OFF_PLANE");
  add(kStickyDepthSaturated, "DEPTH_SATURATED");
  add(topology::kStickyListOverflow, "LIST_OVERFLOW");
  add(topology::kStickyQuadOffPlane, "QUAD_OFF_PLANE");
  add(kStickyBehindLight, "BEHIND_LIGHT");
  add(slb::kStickyLineOverflow, "LINE_OVERFLOW");
  add(slb::kStickyObjectOverflow, "OBJECT_OVERFLOW");
  add(slb::kStickyWindingSaturated, "WINDING_SATURATED");
  constexpr std::uint32_t kKnown = kStickyErrorSeen | kStickyOffPlane | kStickyDepthSaturated |
                                   topology::kStickyListOverflow | topology::kStickyQuadOffPlane |
                                   kStickyBehindLight | slb::kStickyLineOverflow |
                                   slb::kStickyObjectOverflow | slb::kStickyWindingSaturated;
  const std::uint32_t unknown = sticky & ~kKnown;
  if (unknown != 0) add(unknown, hex(unknown, 6).c_str());
  return names.empty() ? "none" : names;
}

std::string voxel_text(const VoxelResult& result) {
  std::string text = "VOXEL_STATE " + state_name(result.state);
  if (result.facing_away) text += " facing_away";
  if (result.off_plane) text += " off_plane";
  if (result.uncertain) text += " uncertain";
  if (result.offset_empty) text += " offset_empty";
  if (result.beyond_max) text += " beyond_max";
  if (result.outside_cone) text += " outside_cone";
  if (result.behind) text += " behind";
  return text + " nearest=" + depth_text(result.nearest) + " delta=" + std::to_string(result.delta);
}

std::string plane_entry_text(const PlaneEntryResult& result) {
  return "PLANE_ENTRY index=" + std::to_string(result.index) +
         (result.present ? " depth=" + std::to_string(result.depth)
                         : " empty" + (result.depth == 0 ? "" : " depth=" + std::to_string(result.depth)));
}

/// Only bits that must be zero tell these two words apart.
std::string zero_bits_text(Word word, Word canonical) {
  return word == canonical ? "" : " reserved=" + hex(word ^ canonical, 16);
}

}  // namespace

std::string describe_result(Word word) {
  const auto code = static_cast<std::uint8_t>(result_code(word));
  if (code == slb::kAnswerCode) return slb::describe_answer(word);
  if (code == slb::kEntryCode) return slb::describe_entry_header(word);
  if (code == frame::kStatesCode) return frame::describe_states(word);
  if (code == topology::kStateCode || code == topology::kListHeadCode)
    return topology::describe_topology_result(word);
  switch (result_code(word)) {
    case ResultCode::Fence: {
      const FenceResult result = decode_fence_result(word);
      return "FENCE tag=" + std::to_string(result.tag) + " sticky=" + sticky_text(result.sticky);
    }
    case ResultCode::PlaneEntry: {
      const PlaneEntryResult result = decode_plane_entry_result(word);
      return plane_entry_text(result) + zero_bits_text(word, encode(result));
    }
    case ResultCode::VoxelState: {
      const VoxelResult result = decode_voxel_result(word);
      return voxel_text(result) + zero_bits_text(word, encode(result));
    }
    case ResultCode::Error: {
      const ErrorResult result = decode_error_result(word);
      return "ERROR " + error_name(result.error) + " command=" + std::to_string(result.command_index) +
             zero_bits_text(word, encode(result));
    }
  }
  return "unknown result " + hex(word, 16);
}

std::string describe_header(Word word) {
  const Header header = decode_header(word);
  return op_name(header.op) + " flags=" + hex(header.flags, 2) + " count=" + std::to_string(header.count) +
         " arg=" + hex(header.arg, 8);
}

}  // namespace gnomon::golden
