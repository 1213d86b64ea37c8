// SPDX-License-Identifier: Apache-2.0
// A model spec in Verilator's words.
#include "sim/model_spec.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace gnomon::sim {

namespace {

using Parameters = std::vector<std::pair<const char*, int>>;

/// Every parameter of gnomon_core with its value. Those of a unit left out are left out too, so that hardware
/// that is the same has the same arguments.
Parameters parameters(const golden::HardwareConfig& config) {
  Parameters list{{"VOXEL_BITS", config.voxel_bits},
                  {"VOXEL_FRAC_BITS", config.voxel_frac_bits},
                  {"NORMAL_BITS", config.normal_bits},
                  {"MATRIX_FRAC_BITS", config.matrix_frac_bits},
                  {"DEPTH_BITS", config.depth_bits},
                  {"PLANE_LOG2", config.plane_log2},
                  {"EN_VPU_OFFSET", config.en_vpu_offset ? 1 : 0}};
  if (config.en_perspective) list.emplace_back("EN_PERSPECTIVE", 1);
  if (config.en_vpu_topology) {
    const Parameters topology{{"EN_VPU_TOPOLOGY", 1},
                              {"SUB_BITS", config.sub_bits},
                              {"SPAN_LOG2", config.span_log2},
                              {"NODES_LOG2", config.nodes_log2},
                              {"QUADS_LOG2", config.quads_log2}};
    list.insert(list.end(), topology.begin(), topology.end());
  }
  if (config.en_frame_buffer) {
    list.emplace_back("EN_FRAME_BUFFER", 1);
    list.emplace_back("FRAME_LAYERS_LOG2", config.frame_layers_log2);
  }
  if (!config.en_slb) return list;
  const Parameters slb{{"EN_SLB", 1},
                       {"SLB_PLANE_LOG2", config.slb_plane_log2},
                       {"FRAC_BITS", config.frac_bits},
                       {"SLOPE_BITS", config.slope_bits},
                       {"FRAGS_PER_PIXEL", config.frags_per_pixel},
                       {"SUBPIXEL_BITS", config.subpixel_bits},
                       {"QUERY_BITS", config.query_bits},
                       {"SLB_ROUNDING", static_cast<int>(config.slb_rounding)}};
  list.insert(list.end(), slb.begin(), slb.end());
  return list;
}

}  // namespace

std::string describe(const golden::HardwareConfig& config) {
  std::string text;
  for (const auto& [name, value] : parameters(config)) {
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
  }
  return text;
}

const char* module_name(ModelTop top) {
  return top == ModelTop::Bus ? "gnomon_top" : "gnomon_core";
}

std::string describe(const ModelSpec& spec) {
  std::string text = describe(spec.config);
  if (spec.top == ModelTop::Bus)
    text += fmt::format(" CACHE_LOG2={} AXI_DATA_BITS={}", spec.cache_log2, spec.axi_data_bits);
  if (spec.cache_log2 != 0 && spec.line_ids_log2 != 4)
    text += fmt::format(" LINE_IDS_LOG2={}", spec.line_ids_log2);
  if (spec.memory_latency != 1) text += fmt::format(" MEM_LATENCY={}", spec.memory_latency);
  if (spec.memory_stall_seed != 0) text += fmt::format(" MEM_STALL_SEED={}", spec.memory_stall_seed);
  if (spec.config.en_slb && spec.slb_dividers != 2)
    text += fmt::format(" SLB_DIVIDERS={}", spec.slb_dividers);
  for (const std::string& define : spec.defines) text += " " + define;
  if (spec.trace) text += " (with waveforms)";
  if (spec.coverage) text += " (with coverage)";
  if (spec.assertions) text += " (with assertions)";
  if (spec.plain_bit_operations) text += " (with plain bit operations)";
  if (spec.quick_build) text += " (compiled quickly)";
  return text;
}

std::vector<std::string> verilator_arguments(const ModelSpec& spec) {
  // Waveforms are in ns. What is x in SystemVerilog is random here, so that a result depending on it shows
  // up.
  const std::string module = module_name(spec.top);
  std::vector<std::string> arguments{
      "--cc",       "--top-module", module,        "--prefix", "V" + module,           "-O3",
      "--x-assign", "unique",       "--x-initial", "unique",   "--timescale-override", "1ns/1ns"};
  for (const auto& [name, value] : parameters(spec.config)) {
    const bool one_bit = std::string_view(name).starts_with("EN_");
    arguments.push_back(fmt::format("-G{}={}{}", name, one_bit ? "1'b" : "", value));
  }
  arguments.push_back(fmt::format("-GMEM_LATENCY={}", spec.memory_latency));
  arguments.push_back(fmt::format("-GMEM_STALL_SEED={}", spec.memory_stall_seed));
  if (spec.config.en_slb) arguments.push_back(fmt::format("-GSLB_DIVIDERS={}", spec.slb_dividers));
  if (spec.top == ModelTop::Bus) {
    arguments.push_back(fmt::format("-GCACHE_LOG2={}", spec.cache_log2));
    if (spec.cache_log2 != 0) arguments.push_back(fmt::format("-GLINE_IDS_LOG2={}", spec.line_ids_log2));
    arguments.push_back(fmt::format("-GAXI_DATA_BITS={}", spec.axi_data_bits));
  }
  for (const std::string& define : spec.defines) arguments.push_back("+define+" + define);
  if (spec.trace) arguments.insert(arguments.end(), {"--trace-fst", "--trace-structs"});
  if (spec.coverage) {  // Verilator offers only one of coverage and saving
    arguments.insert(arguments.end(), {"--coverage-line", "--coverage-toggle", "--coverage-user"});
  } else if (spec.top == ModelTop::Core) {
    arguments.push_back("--savable");
  }
  if (spec.assertions) arguments.push_back("--assert");
  if (spec.plain_bit_operations) arguments.push_back("-fno-const-bit-op-tree");
  return arguments;
}

}  // namespace gnomon::sim
