// SPDX-License-Identifier: Apache-2.0
// The legality rules of docs/vpu.md, docs/vpu-topology.md, docs/frame-buffer.md and docs/slb.md, in the one
// place where C++ holds them.
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <tuple>

namespace gnomon::golden {
namespace {

struct Range {
  const char* name;
  int value, low, high;
};

std::string out_of_range(const Range& range) {
  return std::string(range.name) + "=" + std::to_string(range.value) + " is out of range " +
         std::to_string(range.low) + ".." + std::to_string(range.high);
}

auto vpu_parameters(const HardwareConfig& c) {
  return std::tie(c.voxel_bits, c.voxel_frac_bits, c.normal_bits, c.matrix_frac_bits, c.depth_bits,
                  c.plane_log2, c.en_vpu_offset, c.en_perspective, c.en_vpu_topology, c.en_frame_buffer,
                  c.en_slb);
}

std::optional<std::string> check_slb(const HardwareConfig& config) {
  const Range plane{"SLB_PLANE_LOG2", config.slb_plane_log2, 3, 12};
  if (plane.value < plane.low || plane.value > plane.high) return out_of_range(plane);
  const slb::SlbConfig slb = config.slb_config();
  if (auto error = slb.check()) return error;
  return slb::check_items(slb);
}

}  // namespace

bool HardwareConfig::operator==(const HardwareConfig& other) const {
  if (vpu_parameters(*this) != vpu_parameters(other)) return false;
  if (en_vpu_topology && topology_config() != other.topology_config()) return false;
  if (en_frame_buffer && frame_config() != other.frame_config()) return false;
  return !en_slb || slb_config() == other.slb_config();
}

topology::TopologyConfig HardwareConfig::topology_config() const {
  return {.voxel_bits = voxel_bits,
          .voxel_frac_bits = voxel_frac_bits,
          .normal_bits = normal_bits,
          .matrix_frac_bits = matrix_frac_bits,
          .depth_bits = depth_bits,
          .plane_log2 = plane_log2,
          .sub_bits = sub_bits,
          .span_log2 = span_log2,
          .nodes_log2 = nodes_log2,
          .quads_log2 = quads_log2};
}

frame::FrameConfig HardwareConfig::frame_config() const {
  return {.voxel_bits = voxel_bits, .voxel_frac_bits = voxel_frac_bits, .layers_log2 = frame_layers_log2};
}

slb::SlbConfig HardwareConfig::slb_config() const {
  return {.frac_bits = frac_bits,
          .slope_bits = slope_bits,
          .frags = frags_per_pixel,
          .depth_bits = depth_bits,
          .plane_log2 = slb_plane_log2,
          .subpixel_bits = subpixel_bits,
          .query_bits = query_bits,
          .rounding = slb_rounding};
}

std::optional<std::string> HardwareConfig::check() const {
  const Range ranges[] = {
      {"VOXEL_BITS", voxel_bits, 4, 11},   {"VOXEL_FRAC_BITS", voxel_frac_bits, 0, 6},
      {"NORMAL_BITS", normal_bits, 4, 12}, {"MATRIX_FRAC_BITS", matrix_frac_bits, 12, 28},
      {"DEPTH_BITS", depth_bits, 8, 24},   {"PLANE_LOG2", plane_log2, 4, 12},
  };
  for (const Range& range : ranges) {
    if (range.value < range.low || range.value > range.high) return out_of_range(range);
  }
  const int p = position_bits();
  if (p > 16) {
    return "VOXEL_BITS + VOXEL_FRAC_BITS = " + std::to_string(p) + " exceeds 16";
  }
  if (3 * (p + normal_bits) > 63) {
    return "3 * (VOXEL_BITS + VOXEL_FRAC_BITS + NORMAL_BITS) = " + std::to_string(3 * (p + normal_bits)) +
           " exceeds the 63 bits of a voxel item";
  }
  if (matrix_frac_bits < p + 2) {
    return "MATRIX_FRAC_BITS=" + std::to_string(matrix_frac_bits) +
           " is below VOXEL_BITS + VOXEL_FRAC_BITS + 2 = " + std::to_string(p + 2);
  }
  if (en_vpu_topology) {
    if (auto error = topology_config().check()) return error;
  }
  if (en_frame_buffer) {
    if (auto error = frame_config().check()) return error;
  }
  return en_slb ? check_slb(*this) : std::nullopt;
}

}  // namespace gnomon::golden
