// SPDX-License-Identifier: Apache-2.0
// Parameters of topology mode (docs/vpu-topology.md, "Parameters").
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gnomon::golden::topology {

/// One build of the mode. Names and meanings are those of the SystemVerilog parameters; the first six are
/// the projection unit's own.
struct TopologyConfig {
  int voxel_bits = 8;         ///< VOXEL_BITS, 4..11
  int voxel_frac_bits = 2;    ///< VOXEL_FRAC_BITS, 0..6
  int normal_bits = 9;        ///< NORMAL_BITS, 4..12
  int matrix_frac_bits = 22;  ///< MATRIX_FRAC_BITS, 12..28
  int depth_bits = 20;        ///< DEPTH_BITS, 8..24
  int plane_log2 = 9;         ///< PLANE_LOG2, 4..12

  int sub_bits = 4;     ///< SUB_BITS S, 2..8
  int span_log2 = 4;    ///< SPAN_LOG2 s, 2..6
  int nodes_log2 = 20;  ///< NODES_LOG2, 4..24
  int quads_log2 = 18;  ///< QUADS_LOG2, 4..24

  bool operator==(const TopologyConfig&) const = default;

  /// Nothing if the combination is legal; else one line naming the parameter, its value and the rule.
  std::optional<std::string> check() const;

  int position_bits() const { return voxel_bits + voxel_frac_bits; }   ///< P
  std::int64_t side() const { return std::int64_t{1} << plane_log2; }  ///< entries
  std::uint32_t no_depth() const { return (std::uint32_t{1} << depth_bits) - 1; }
};

}  // namespace gnomon::golden::topology
