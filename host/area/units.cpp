// SPDX-License-Identifier: Apache-2.0
// Parameters as gnomon_core.sv, slb.sv and topology.sv hand them down.
#include "host/area/units.hpp"

#include <span>

namespace gnomon::area {
namespace {

using Parameters = std::vector<std::pair<std::string, int>>;

/// Those of `all` that are named.
Parameters some(const Parameters& all, std::initializer_list<std::string_view> names) {
  Parameters chosen;
  for (const std::string_view name : names) {
    for (const auto& parameter : all)
      if (parameter.first == name) chosen.push_back(parameter);
  }
  return chosen;
}

void add_projection(const golden::HardwareConfig& c, std::vector<Unit>& units) {
  const Parameters all{{"VOXEL_BITS", c.voxel_bits},
                       {"VOXEL_FRAC_BITS", c.voxel_frac_bits},
                       {"NORMAL_BITS", c.normal_bits},
                       {"MATRIX_FRAC_BITS", c.matrix_frac_bits},
                       {"DEPTH_BITS", c.depth_bits},
                       {"PLANE_LOG2", c.plane_log2},
                       {"EN_VPU_OFFSET", c.en_vpu_offset ? 1 : 0},
                       {"EN_VPU_TOPOLOGY", c.en_vpu_topology ? 1 : 0},
                       {"EN_PERSPECTIVE", c.en_perspective ? 1 : 0}};
  units.push_back({"vpu_front", 1, all});
  if (!c.en_vpu_offset) return;
  units.push_back({"vpu", 1, some(all, {"DEPTH_BITS", "PLANE_LOG2", "EN_VPU_OFFSET", "EN_PERSPECTIVE"})});
}

void add_topology(const golden::HardwareConfig& c, std::vector<Unit>& units) {
  const Parameters all{{"DEPTH_BITS", c.depth_bits}, {"PLANE_LOG2", c.plane_log2},
                       {"SUB_BITS", c.sub_bits},     {"SPAN_LOG2", c.span_log2},
                       {"NODES_LOG2", c.nodes_log2}, {"QUADS_LOG2", c.quads_log2}};
  units.push_back({"topology_put", 1, all});
  units.push_back({"topology_hit", 1, some(all, {"PLANE_LOG2", "SUB_BITS", "SPAN_LOG2"})});
}

void add_silhouettes(const golden::HardwareConfig& c, std::vector<Unit>& units) {
  const Parameters all{{"FRAC_BITS", c.frac_bits},
                       {"SLOPE_BITS", c.slope_bits},
                       {"FRAGS_PER_PIXEL", c.frags_per_pixel},
                       {"DEPTH_BITS", c.depth_bits},
                       {"PLANE_LOG2", c.slb_plane_log2},
                       {"SUBPIXEL_BITS", c.subpixel_bits},
                       {"QUERY_BITS", c.query_bits},
                       {"ROUNDING", static_cast<int>(c.slb_rounding)}};
  const auto add = [&](const char* module, int count, std::initializer_list<std::string_view> names) {
    units.push_back({module, count, some(all, names)});
  };
  add("slb_edge_fold", 1, {"DEPTH_BITS", "PLANE_LOG2", "SUBPIXEL_BITS"});
  add("slb_edge_divide", 1, {"FRAC_BITS", "DEPTH_BITS", "PLANE_LOG2", "SUBPIXEL_BITS"});
  add("slb_edge_place", 1, {"FRAC_BITS", "DEPTH_BITS", "PLANE_LOG2", "SUBPIXEL_BITS"});
  add("slb_walker", 1, {"FRAC_BITS", "DEPTH_BITS", "PLANE_LOG2", "SUBPIXEL_BITS"});
  add("slb_line_encoder", 2, {"FRAC_BITS", "SLOPE_BITS", "SUBPIXEL_BITS", "ROUNDING"});
  add("slb_chain_builder", 1, {"FRAC_BITS", "SLOPE_BITS", "DEPTH_BITS", "PLANE_LOG2", "SUBPIXEL_BITS"});
  add("slb_query", 1,
      {"FRAC_BITS", "SLOPE_BITS", "FRAGS_PER_PIXEL", "DEPTH_BITS", "PLANE_LOG2", "QUERY_BITS", "ROUNDING"});
}

}  // namespace

std::vector<Unit> units_of(const golden::HardwareConfig& config) {
  std::vector<Unit> units;
  if (config.en_vpu_offset || config.en_vpu_topology) add_projection(config, units);
  if (config.en_vpu_topology) add_topology(config, units);
  if (config.en_slb) add_silhouettes(config, units);
  return units;
}

}  // namespace gnomon::area
