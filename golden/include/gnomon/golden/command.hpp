// SPDX-License-Identifier: Apache-2.0
// What headers alone decide: whether a command is in error, and how many result words it gives
// (docs/command-stream.md).
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/slb/sequence.hpp>
#include <optional>

namespace gnomon::golden {

/// Judges the commands of a stream that starts at reset, one after the other: what is allowed may depend on
/// what came before.
class CommandSequence {
 public:
  explicit CommandSequence(const HardwareConfig& config) : config_(config) {}

  /// The error that the next command is answered with, the first of 1, 5, 2, 3, 4, 6 that applies; nothing if
  /// it is sound.
  std::optional<ErrorCode> next(const Header& header);

 private:
  std::optional<ErrorCode> error_without_frame(const Header& header) const;
  std::optional<ErrorCode> frame_error(const Header& header) const;
  std::optional<ErrorCode> resolve_error(Header header) const;
  std::optional<ErrorCode> slb_error(const Header& header) const;
  std::optional<ErrorCode> topology_error(const Header& header) const;

  HardwareConfig config_;
  slb::SlbSequence slb_;
};

/// Result words of the whole command; one if it is in error.
std::uint32_t result_count(const Header& header, std::optional<ErrorCode> error,
                           const HardwareConfig& config);

/// The argument of READ_PLANE.
struct PlaneRange {
  std::uint32_t first = 0;  ///< entry, 24 bits
  std::uint32_t count = 1;  ///< entries, 1..256
};
std::uint32_t encode(const PlaneRange& range);
PlaneRange decode_plane_range(std::uint32_t arg);

}  // namespace gnomon::golden
