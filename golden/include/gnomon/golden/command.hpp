// SPDX-License-Identifier: Apache-2.0
// What a header alone decides: whether the command is in error, and how many result words it gives
// (docs/command-stream.md).
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <optional>

namespace gnomon::golden {

/// The error a command is answered with, the first of 1, 5, 2, 3, 4 that applies; nothing if it is sound.
std::optional<ErrorCode> header_error(const Header& header, const HardwareConfig& config);

/// Result words of the whole command, the one of a command in error included.
std::uint32_t result_count(const Header& header, const HardwareConfig& config);

/// The argument of READ_PLANE.
struct PlaneRange {
  std::uint32_t first = 0;  ///< entry, 24 bits
  std::uint32_t count = 1;  ///< entries, 1..256
};
std::uint32_t encode(const PlaneRange& range);
PlaneRange decode_plane_range(std::uint32_t arg);

}  // namespace gnomon::golden
