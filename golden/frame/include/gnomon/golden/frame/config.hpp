// SPDX-License-Identifier: Apache-2.0
// Parameters of the cubic frame buffer (docs/frame-buffer.md, "Parameters").
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gnomon::golden::frame {

/// One build of the frame buffer. Names and meanings are those of the SystemVerilog parameters; the first
/// two are the projection unit's own.
struct FrameConfig {
  int voxel_bits = 8;       ///< VOXEL_BITS V, 4..11
  int voxel_frac_bits = 2;  ///< VOXEL_FRAC_BITS F, 0..6
  int layers_log2 = 0;      ///< FRAME_LAYERS_LOG2 L, 0..3

  bool operator==(const FrameConfig&) const = default;

  /// Nothing if the combination is legal; else one line naming the parameter, its value and the rule.
  std::optional<std::string> check() const;

  std::uint32_t layers() const { return std::uint32_t{1} << layers_log2; }
  int position_bits() const { return voxel_bits + voxel_frac_bits; }  ///< P
  /// Bits of the states alone, without generations.
  std::uint64_t state_bits() const { return std::uint64_t{2} << (3 * voxel_bits + layers_log2); }
};

}  // namespace gnomon::golden::frame
