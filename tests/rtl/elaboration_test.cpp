// SPDX-License-Identifier: Apache-2.0
// Which parameters the hardware can be built with: every build of the covering array is lint-clean in
// Verilator and read by Yosys; every illegal set stops both with its message, and the golden model refuses it
// too.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <gnomon/golden/config.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/covering.hpp"

namespace gnomon::rtl_test {
namespace {

using golden::HardwareConfig;

struct Outcome {
  int status = 0;
  std::string text;
};

Outcome run(const std::string& command) {
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return {-1, "cannot run " + command};
  Outcome outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.text.append(buffer.data(), count);
  }
  outcome.status = pclose(pipe);
  return outcome;
}

using Parameters = std::array<std::pair<const char*, int>, 23>;
Parameters parameters(const HardwareConfig& config) {
  return {{{"VOXEL_BITS", config.voxel_bits},
           {"VOXEL_FRAC_BITS", config.voxel_frac_bits},
           {"NORMAL_BITS", config.normal_bits},
           {"MATRIX_FRAC_BITS", config.matrix_frac_bits},
           {"DEPTH_BITS", config.depth_bits},
           {"PLANE_LOG2", config.plane_log2},
           {"EN_VPU_OFFSET", config.en_vpu_offset ? 1 : 0},
           {"EN_PERSPECTIVE", config.en_perspective ? 1 : 0},
           {"EN_VPU_TOPOLOGY", config.en_vpu_topology ? 1 : 0},
           {"SUB_BITS", config.sub_bits},
           {"SPAN_LOG2", config.span_log2},
           {"NODES_LOG2", config.nodes_log2},
           {"QUADS_LOG2", config.quads_log2},
           {"EN_FRAME_BUFFER", config.en_frame_buffer ? 1 : 0},
           {"FRAME_LAYERS_LOG2", config.frame_layers_log2},
           {"EN_SLB", config.en_slb ? 1 : 0},
           {"SLB_PLANE_LOG2", config.slb_plane_log2},
           {"FRAC_BITS", config.frac_bits},
           {"SLOPE_BITS", config.slope_bits},
           {"FRAGS_PER_PIXEL", config.frags_per_pixel},
           {"SUBPIXEL_BITS", config.subpixel_bits},
           {"QUERY_BITS", config.query_bits},
           {"SLB_ROUNDING", static_cast<int>(config.slb_rounding)}}};
}

Outcome verilator(const HardwareConfig& config, const std::string& more = {},
                  const std::string& top = "gnomon_core") {
  std::string command =
      VERILATOR_PROGRAM " --lint-only -Wall --assert -F " RTL_DIR "/gnomon.f --top-module " + top;
  for (const auto& [name, value] : parameters(config)) {
    command += std::string(" -G") + name + "=" + (std::string_view(name).starts_with("EN_") ? "1\\'b" : "") +
               std::to_string(value);
  }
  return run(command + more);
}

Outcome yosys(const HardwareConfig& config, const std::string& sources, const std::string& top) {
  std::string script = "read_verilog -sv -I" RTL_DIR "/common " + sources + "; hierarchy -check -top " + top;
  for (const auto& [name, value] : parameters(config)) {
    const std::string_view parameter = name;
    if (top == "parameter_check" && (parameter == "EN_VPU_OFFSET" || parameter == "EN_PERSPECTIVE"))
      continue;  // legal either way
    script += std::string(" -chparam ") + name + " " + std::to_string(value);
  }
  return run(YOSYS_PROGRAM " -q -p '" + script + "; proc; check -assert'");
}
Outcome yosys(const HardwareConfig& config) {
  return yosys(config, RTL_SOURCES, "gnomon_core");
}
/// The check by itself, which is quicker; that gnomon_core hands it every parameter is seen in Verilator.
Outcome yosys_check(const HardwareConfig& config) {
  return yosys(config, RTL_DIR "/parameter_check.sv", "parameter_check");
}

/// The first dozen as gnomon_top, with every bus and, on each, no caches, the smallest and the largest.
TEST(Elaboration, EveryBuildOfTheCoveringArrayIsLintClean) {
  constexpr std::array kCaches{0, 12, 16};
  constexpr std::array kBuses{64, 128, 256, 512};
  const auto builds = stimulus::covering_array();
  ASSERT_GE(builds.size(), kCaches.size() * kBuses.size());
  for (std::size_t i = 0; i < builds.size(); ++i) {
    const bool on_bus = i < kCaches.size() * kBuses.size();
    const std::string bus = " -GCACHE_LOG2=" + std::to_string(kCaches.at(i % kCaches.size())) +
                            " -GAXI_DATA_BITS=" + std::to_string(kBuses.at(i % kBuses.size()));
    const Outcome outcome = on_bus ? verilator(builds[i], bus, "gnomon_top") : verilator(builds[i]);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(outcome.text, "");
  }
}

/// And the two largest of those that are legal.
TEST(Elaboration, EveryBuildOfTheFrameBufferIsLintClean) {
  std::vector<HardwareConfig> builds = stimulus::frame_covering_array();
  builds.push_back(stimulus::large_frame_config());
  builds.push_back({.voxel_bits = 11, .voxel_frac_bits = 0, .en_frame_buffer = true});
  builds.push_back({.voxel_bits = 10, .voxel_frac_bits = 0, .en_frame_buffer = true, .frame_layers_log2 = 3});
  for (const HardwareConfig& config : builds) {
    const Outcome outcome = verilator(config);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    EXPECT_EQ(outcome.text, "");
  }
}

TEST(Elaboration, YosysReadsAndChecksBuildsOfTheCoveringArray) {
  const auto builds = stimulus::covering_array();
  int with_topology = 0;
  for (std::size_t i = 0; i < builds.size(); i += 8) {
    const Outcome outcome = yosys(builds[i]);
    EXPECT_EQ(outcome.status, 0) << outcome.text;
    with_topology += builds[i].en_vpu_topology;
  }
  EXPECT_GE(with_topology, 2);
}

struct Illegal {
  const char* message;  ///< of the hardware's check
  HardwareConfig config;
};
std::vector<Illegal> illegal_builds() {
  return {
      {"VOXEL_BITS is out of range 4..11", {.voxel_bits = 3}},
      {"VOXEL_BITS is out of range 4..11", {.voxel_bits = 12, .normal_bits = 4}},
      {"VOXEL_FRAC_BITS is out of range 0..6", {.voxel_frac_bits = 7, .normal_bits = 4}},
      {"VOXEL_BITS + VOXEL_FRAC_BITS is above 16",
       {.voxel_bits = 11, .voxel_frac_bits = 6, .normal_bits = 4}},
      {"NORMAL_BITS is out of range 4..12", {.normal_bits = 3}},
      {"NORMAL_BITS is out of range 4..12", {.voxel_bits = 4, .normal_bits = 13}},
      {"a voxel does not fit a word", {.normal_bits = 12}},
      {"MATRIX_FRAC_BITS is out of range 12..28",
       {.voxel_bits = 4, .voxel_frac_bits = 0, .matrix_frac_bits = 11}},
      {"MATRIX_FRAC_BITS is out of range 12..28", {.matrix_frac_bits = 29}},
      {"MATRIX_FRAC_BITS is below VOXEL_BITS + VOXEL_FRAC_BITS + 2",
       {.voxel_bits = 11, .voxel_frac_bits = 2, .normal_bits = 8, .matrix_frac_bits = 14}},
      {"DEPTH_BITS is out of range 8..24", {.depth_bits = 7}},
      {"DEPTH_BITS is out of range 8..24", {.depth_bits = 25}},
      {"PLANE_LOG2 is out of range 4..12", {.plane_log2 = 3}},
      {"PLANE_LOG2 is out of range 4..12", {.plane_log2 = 13}},
      {"SUB_BITS is out of range 2..8", {.en_vpu_topology = true, .sub_bits = 1}},
      {"SUB_BITS is out of range 2..8", {.en_vpu_topology = true, .sub_bits = 9}},
      {"SPAN_LOG2 is out of range 2..6", {.en_vpu_topology = true, .span_log2 = 1}},
      {"SPAN_LOG2 is out of range 2..6", {.en_vpu_topology = true, .span_log2 = 7}},
      {"NODES_LOG2 is out of range 4..24", {.en_vpu_topology = true, .nodes_log2 = 3}},
      {"NODES_LOG2 is out of range 4..24", {.en_vpu_topology = true, .nodes_log2 = 25}},
      {"QUADS_LOG2 is out of range 4..24", {.en_vpu_topology = true, .quads_log2 = 3}},
      {"QUADS_LOG2 is out of range 4..24", {.en_vpu_topology = true, .quads_log2 = 25}},
      {"FRAME_LAYERS_LOG2 is out of range 0..3", {.en_frame_buffer = true, .frame_layers_log2 = 4}},
      {"3 VOXEL_BITS + FRAME_LAYERS_LOG2 + 1 is above 34",
       {.voxel_bits = 11, .voxel_frac_bits = 0, .en_frame_buffer = true, .frame_layers_log2 = 1}},
      {"FRAC_BITS is out of range 3..8", {.en_slb = true, .frac_bits = 2}},
      {"FRAC_BITS is out of range 3..8",
       {.en_slb = true, .frac_bits = 9, .subpixel_bits = 12, .query_bits = 12}},
      {"SLOPE_BITS is out of range 3..9", {.en_slb = true, .slope_bits = 2}},
      {"SLOPE_BITS is out of range 3..9", {.en_slb = true, .slope_bits = 10}},
      {"FRAGS_PER_PIXEL is out of range 1..4", {.en_slb = true, .frags_per_pixel = 5}},
      {"FRAGS_PER_PIXEL is out of range 1..4", {.en_slb = true, .frags_per_pixel = 0}},
      {"SLB_PLANE_LOG2 is out of range 3..12", {.en_slb = true, .slb_plane_log2 = 2}},
      {"SLB_PLANE_LOG2 is out of range 3..12", {.en_slb = true, .slb_plane_log2 = 13}},
      {"SUBPIXEL_BITS is out of range FRAC_BITS + 3..16", {.en_slb = true, .subpixel_bits = 9}},
      {"SUBPIXEL_BITS is below SLOPE_BITS - FRAC_BITS + 4",
       {.en_slb = true, .frac_bits = 3, .slope_bits = 9, .subpixel_bits = 9}},
      {"QUERY_BITS is out of range FRAC_BITS + 3..16", {.en_slb = true, .query_bits = 17}},
      {"a vertex does not fit a word", {.depth_bits = 24, .en_slb = true, .subpixel_bits = 13}},
      {"a query does not fit a word", {.depth_bits = 24, .en_slb = true, .query_bits = 13}},
  };
}

TEST(Elaboration, IllegalBuildsStopEveryToolWithTheirMessage) {
  for (const Illegal& build : illegal_builds()) {
    EXPECT_TRUE(build.config.check().has_value()) << build.message;
    for (const Outcome& outcome : {verilator(build.config), yosys_check(build.config)}) {
      EXPECT_NE(outcome.status, 0) << build.message;
      EXPECT_NE(outcome.text.find(build.message), std::string::npos) << outcome.text;
    }
  }
}

TEST(Elaboration, IllegalMemoryParametersStopVerilatorWithTheirMessage) {
  for (const auto& [argument, message] :
       {std::pair{" -GMEM_LATENCY=0", "MEM_LATENCY is out of range 1..64"},
        std::pair{" -GMEM_LATENCY=65", "MEM_LATENCY is out of range 1..64"},
        std::pair{" -GCACHE_LOG2=11", "CACHE_LOG2 is out of range 12..16"},
        std::pair{" -GCACHE_LOG2=17", "CACHE_LOG2 is out of range 12..16"},
        std::pair{" -GEN_SLB=1\\'b1 -GSLB_ROUNDING=2", "SLB_ROUNDING is out of range 0..1"},
        std::pair{" -GEN_SLB=1\\'b1 -GSLB_DIVIDERS=4", "SLB_DIVIDERS is out of range 1..3"},
        std::pair{" -GEN_SLB=1\\'b1 -GSLB_DIVIDERS=0", "SLB_DIVIDERS is out of range 1..3"},
        std::pair{" -GMEM_STALL_SEED=65536", "MEM_STALL_SEED is out of range 0..65535"},
        std::pair{" -GCACHE_LOG2=11", "CACHE_LOG2 is out of range 12..16"},
        std::pair{" -GCACHE_LOG2=12 -GLINE_IDS_LOG2=2", "LINE_IDS_LOG2 is out of range 3..5"},
        std::pair{" -GCACHE_LOG2=12 -GLINE_IDS_LOG2=6", "LINE_IDS_LOG2 is out of range 3..5"}}) {
    const Outcome outcome = verilator({}, argument);
    EXPECT_NE(outcome.status, 0) << argument;
    EXPECT_NE(outcome.text.find(message), std::string::npos) << outcome.text;
  }
  EXPECT_EQ(verilator({}, " -GMEM_LATENCY=64 -GMEM_STALL_SEED=65535").text, "");
  const Outcome bus = verilator({}, " -GAXI_DATA_BITS=96", "gnomon_top");
  EXPECT_NE(bus.status, 0);
  EXPECT_NE(bus.text.find("AXI_DATA_BITS is none of 64, 128, 256, 512"), std::string::npos) << bus.text;
}

}  // namespace
}  // namespace gnomon::rtl_test
