// SPDX-License-Identifier: Apache-2.0
// All parameters, as the main job takes them.
#include "host/cli/run_settings.hpp"

#include "host/cli/scene_input.hpp"
#include "host/cli/slb_settings.hpp"
#include "host/cli/system_settings.hpp"
#include "host/cli/vpu_settings.hpp"

namespace gnomon::cli {

namespace {

plan::TopologySettings topology_settings(const config::Settings& settings, const plan::VpuSettings& vpu) {
  const auto integer = [&](std::string_view key) { return static_cast<int>(settings.integer(key)); };
  plan::TopologySettings topology;
  if (settings.entry("pitch").origin != "default") topology.pitch = vpu.pitch;
  topology.lift = settings.number("lift");
  topology.clearance = settings.number("clearance");
  topology.plane_log2 = vpu.plane_log2;
  topology.voxel_frac_bits = vpu.voxel_frac_bits;
  topology.normal_bits = vpu.normal_bits;
  topology.matrix_frac_bits = vpu.matrix_frac_bits;
  topology.depth_bits = vpu.depth_bits;
  topology.sub_bits = integer("sub_bits");
  topology.span_log2 = integer("span_log2");
  topology.nodes_log2 = integer("nodes_log2");
  topology.quads_log2 = integer("quads_log2");
  return topology;
}

}  // namespace

pipeline::RunSettings run_settings(const config::Settings& settings) {
  pipeline::RunSettings run;
  run.res = static_cast<std::uint32_t>(settings.integer("res"));
  run.adjacency = adjacency_of(settings);
  run.techniques = settings.words("technique");
  run.vpu = vpu_settings(settings);
  run.topology = topology_settings(settings, run.vpu);
  run.slb = slb_settings(settings);
  run.order = settings.word("order") == "tile" ? plan::ItemOrder::Tile : plan::ItemOrder::Surface;
  run.maps.memory = settings.word("map_memory");
  run.maps.side = static_cast<int>(settings.integer("map_side"));
  run.maps.kernel = static_cast<int>(settings.integer("pcf_kernel"));
  run.ray_sag = settings.number("ray_sag");
  run.frame_buffer = settings.is_on("frame_buffer");
  run.system = system_settings(settings);
  run.memory_given = gives_memory(settings);
  run.clock_mhz = settings.number("clock_mhz");
  run.image_width = static_cast<int>(settings.integer("image_width"));
  run.image_height = static_cast<int>(settings.integer("image_height"));
  run.threads = static_cast<unsigned>(settings.integer("threads"));
  return run;
}

}  // namespace gnomon::cli
