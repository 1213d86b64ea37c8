// SPDX-License-Identifier: Apache-2.0
// The parameters a piece of hardware is built with, and the widths that follow from them (docs/vpu.md,
// docs/vpu-topology.md, docs/slb.md, docs/frame-buffer.md).
#pragma once

#include <gnomon/golden/frame/config.hpp>
#include <gnomon/golden/slb/config.hpp>
#include <gnomon/golden/topology/config.hpp>
#include <optional>
#include <string>

namespace gnomon::golden {

/// One hardware build. Names and meanings are those of the SystemVerilog parameters.
struct HardwareConfig {
  int voxel_bits = 8;           ///< VOXEL_BITS, 4..11
  int voxel_frac_bits = 2;      ///< VOXEL_FRAC_BITS, 0..6
  int normal_bits = 9;          ///< NORMAL_BITS, 4..12
  int matrix_frac_bits = 22;    ///< MATRIX_FRAC_BITS, 12..28
  int depth_bits = 20;          ///< DEPTH_BITS, 8..24
  int plane_log2 = 9;           ///< PLANE_LOG2, 4..12
  bool en_vpu_offset = true;    ///< EN_VPU_OFFSET
  bool en_perspective = false;  ///< EN_PERSPECTIVE: with spots and point lights

  bool en_vpu_topology =
      false;            ///< EN_VPU_TOPOLOGY: with topology mode. Without it, the next four mean nothing
  int sub_bits = 4;     ///< SUB_BITS, 2..8
  int span_log2 = 4;    ///< SPAN_LOG2, 2..6
  int nodes_log2 = 20;  ///< NODES_LOG2, 4..24
  int quads_log2 = 18;  ///< QUADS_LOG2, 4..24

  bool en_frame_buffer = false;  ///< EN_FRAME_BUFFER: states are kept. Without it, the next means nothing
  int frame_layers_log2 = 0;     ///< FRAME_LAYERS_LOG2, 0..3

  bool en_slb = false;      ///< EN_SLB: with the silhouette-line buffer. Without it, the rest means nothing
  int slb_plane_log2 = 8;   ///< SLB_PLANE_LOG2, 3..12; the unit has a plane of its own
  int frac_bits = 7;        ///< FRAC_BITS, 3..8
  int slope_bits = 7;       ///< SLOPE_BITS, 3..9
  int frags_per_pixel = 2;  ///< FRAGS_PER_PIXEL, 1..4
  int subpixel_bits = 10;   ///< SUBPIXEL_BITS, FRAC_BITS + 3..16
  int query_bits = 10;      ///< QUERY_BITS, FRAC_BITS + 3..16
  slb::Rounding slb_rounding = slb::Rounding::Better;  ///< SLB_ROUNDING

  /// The same hardware: parameters of a unit that neither has do not count.
  bool operator==(const HardwareConfig& other) const;

  /// Nothing if the combination is legal; else one line naming the parameter, its value and the range or
  /// rule.
  std::optional<std::string> check() const;

  int position_bits() const { return voxel_bits + voxel_frac_bits; }  ///< P
  int plane_side() const { return 1 << plane_log2; }                  ///< entries
  topology::TopologyConfig topology_config() const;
  frame::FrameConfig frame_config() const;
  slb::SlbConfig slb_config() const;  ///< DEPTH_BITS is both units'
};

}  // namespace gnomon::golden
