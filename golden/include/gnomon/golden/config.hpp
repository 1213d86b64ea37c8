// SPDX-License-Identifier: Apache-2.0
// The parameters a piece of hardware is built with, and the widths that follow from them (docs/vpu.md).
#pragma once

#include <optional>
#include <string>

namespace gnomon::golden {

/// One hardware build. Names and meanings are those of the SystemVerilog parameters.
struct HardwareConfig {
  int voxel_bits = 8;         ///< VOXEL_BITS, 4..11
  int voxel_frac_bits = 2;    ///< VOXEL_FRAC_BITS, 0..6
  int normal_bits = 9;        ///< NORMAL_BITS, 4..12
  int matrix_frac_bits = 22;  ///< MATRIX_FRAC_BITS, 12..28
  int depth_bits = 20;        ///< DEPTH_BITS, 8..24
  int plane_log2 = 9;         ///< PLANE_LOG2, 4..12
  bool en_vpu_offset = true;  ///< EN_VPU_OFFSET

  bool operator==(const HardwareConfig&) const = default;

  /// Nothing if the combination is legal; else one line naming the parameter, its value and the range or
  /// rule.
  std::optional<std::string> check() const;

  int position_bits() const { return voxel_bits + voxel_frac_bits; }  ///< P
  int plane_side() const { return 1 << plane_log2; }                  ///< entries
};

}  // namespace gnomon::golden
