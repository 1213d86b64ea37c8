// SPDX-License-Identifier: Apache-2.0
// The stimulus is repeatable, well formed, and reaches what it is there to reach.
#include "tests/support/stimulus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>
#include <gnomon/golden/vpu.hpp>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "tests/golden/run_stream.hpp"
#include "tests/support/covering.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::Op;
using golden::ResultCode;
using golden::VoxelState;
using golden::Word;

std::uint64_t fnv1a(std::span<const Word> words) {
  std::uint64_t hash = 0xCBF29CE484222325;
  for (const Word word : words) {
    for (int byte = 0; byte < 8; ++byte) hash = (hash ^ (word >> (8 * byte) & 0xFF)) * 0x100000001B3;
  }
  return hash;
}

TEST(Stimulus, ASeedMeansTheSameWordsEverywhere) {
  const auto words = stimulus::random_stream({}, {.seed = 1});
  EXPECT_EQ(words, stimulus::random_stream({}, {.seed = 1}));
  EXPECT_NE(words, stimulus::random_stream({}, {.seed = 2}));
  EXPECT_EQ(fnv1a(words), 14908086355782831256u)
      << "a changed generator is fine, but then old seeds mean other streams";
}

TEST(Stimulus, StreamsEndBetweenCommandsWithAFence) {
  for (const HardwareConfig& config : stimulus::covering_array()) {
    auto streams = stimulus::directed_streams(config);
    streams.push_back({"random", stimulus::random_stream(config, {.seed = 3})});
    for (const auto& [name, words] : streams) {
      golden::CommandReader reader(words);
      golden::Command last;
      while (const auto command = reader.next()) last = *command;
      EXPECT_EQ(last.items.size(), last.header.count) << name;
      EXPECT_EQ(last.header.op, static_cast<std::uint8_t>(Op::Fence)) << name;
    }
  }
}

/// How often each event, error and way through the resolve pass happened.
std::map<std::string, std::uint64_t> reached(const HardwareConfig& config, std::span<const Word> words) {
  const Outcome outcome = run(config, words);
  auto counts = outcome.events;
  golden::ResultReader reader(outcome.results);
  while (const auto record = reader.next()) {
    const Word word = record->word;
    if (golden::result_code(word) == ResultCode::Error) {
      ++counts["error " + std::to_string(golden::decode_error_result(word).error)];
    }
    if (golden::result_code(word) != ResultCode::VoxelState) continue;
    const auto result = golden::decode_voxel_result(word);
    if (result.delta == 0 || result.beyond_max) continue;
    ++counts[result.state == VoxelState::Lit ? "lit by slope" : "shadow by slope"];
  }
  return counts;
}

/// Ways through the resolve pass in all builds but two: a grid of 16 voxels hardly meets a slope on a plane
/// of 4096² entries, and of a plane of 16² hardly an entry stays empty.
TEST(Stimulus, RandomStreamsReachEverythingInEveryBuild) {
  std::map<std::string, int> builds_reaching;
  int offset_builds = 0;
  for (const HardwareConfig& config : stimulus::covering_array()) {
    std::vector<Word> words;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const int commands = config.en_slb ? 200 : 100;  // half of them are the buffer's
      words = std::move(words) + stimulus::random_stream(config, {.seed = seed, .commands = commands});
    }
    auto counts = reached(config, words);
    for (const char* name : {"SLB_OBJECTS", "SLB_LOOPS", "SLB_CROSSINGS", "SLB_CHAINS",
                             "SLB_CHAINS_OFF_PLANE", "SLB_FILL_GROUPS", "SLB_FILL_COVERED", "SLB_COVERS",
                             "SLB_QUERIES", "SLB_QUERIES_SHADOW", "SLB_QUERIES_OFF_PLANE"}) {
      EXPECT_EQ(counts[name] > 5, config.en_slb) << name << " with SLB_PLANE_LOG2=" << config.slb_plane_log2;
    }
    EXPECT_EQ(counts["error 6"] > 5, config.en_slb);
    for (const char* name : {"PROJECT_OFF_PLANE", "PROJECT_SATURATED", "PLANE_WRITES", "error 1", "error 3",
                             "error 4", "error 5"}) {
      EXPECT_GT(counts[name], 5u) << name << " with PLANE_LOG2=" << config.plane_log2;
    }
    const std::set<std::string> of_resolve{"RESOLVED_FACING_AWAY",  "RESOLVED_UNCERTAIN",
                                           "RESOLVED_OFFSET_EMPTY", "RESOLVED_SHADOW",
                                           "lit by slope",          "shadow by slope"};
    offset_builds += config.en_vpu_offset;
    for (const std::string& name : of_resolve) {
      EXPECT_TRUE(config.en_vpu_offset || counts[name] == 0) << name;
      builds_reaching[name] += counts[name] > 5;
    }
    const bool all_known = config.en_vpu_offset && config.en_vpu_topology && config.en_slb;
    const bool few_unknown = config.en_vpu_offset && config.en_slb;
    if (all_known || !few_unknown) {
      EXPECT_EQ(counts["error 2"] > 0, !all_known);
    }
  }
  EXPECT_EQ(builds_reaching.size(), 6u);
  for (const auto& [name, builds] : builds_reaching) EXPECT_GE(builds, offset_builds - 2) << name;
}

/// Consecutive projected voxels in one entry at distances 1 to 4: what forwarding in a pipeline must get
/// right.
TEST(Stimulus, BurstsHitOneEntryAtEveryShortDistance) {
  const HardwareConfig config;
  std::map<std::size_t, int> hits;
  for (const auto& [name, words] : stimulus::directed_streams(config)) {
    if (name != "burst") continue;
    golden::Vpu vpu(config);
    golden::CommandReader reader(words);
    while (const auto command = reader.next()) {
      if (command->header.op == static_cast<std::uint8_t>(Op::SetRegisters)) {
        for (std::size_t i = 0; i < command->items.size(); ++i) {
          vpu.set(static_cast<golden::Register>(command->header.arg + i), command->items[i]);
        }
      }
      if (command->header.op != static_cast<std::uint8_t>(Op::ProjectVoxels)) continue;
      std::vector<std::size_t> entries;
      for (const Word item : command->items) {
        entries.push_back(vpu.index(vpu.land(vpu.accumulate(golden::decode_voxel(item, config)))));
      }
      for (std::size_t i = 0; i < entries.size(); ++i) {
        for (std::size_t distance = 1; distance <= std::min<std::size_t>(i, 4); ++distance) {
          if (entries[i] == entries[i - distance]) {
            ++hits[distance];
            break;
          }
        }
      }
    }
  }
  for (std::size_t distance = 1; distance <= 4; ++distance)
    EXPECT_GT(hits[distance], 20) << "distance " << distance;
}

/// Values of the parameters at these places, of every two of them.
template <typename Values>
auto pairs(const std::vector<HardwareConfig>& configs, const Values& values) {
  std::set<std::tuple<std::size_t, int, std::size_t, int>> result;
  for (const HardwareConfig& config : configs) {
    const auto v = values(config);
    for (std::size_t i = 0; i < v.size(); ++i) {
      for (std::size_t j = i + 1; j < v.size(); ++j) result.insert({i, v[i], j, v[j]});
    }
  }
  return result;
}

TEST(Covering, EveryPairOfValuesThatSomeBuildHas) {
  const auto vpu = [](const HardwareConfig& c) {
    return std::array<int, 9>{c.voxel_bits,       c.voxel_frac_bits, c.normal_bits,
                              c.matrix_frac_bits, c.depth_bits,      c.plane_log2,
                              c.en_vpu_offset,    c.en_perspective,  c.en_vpu_topology};
  };
  const auto topology = [](const HardwareConfig& c) {
    return std::array<int, 12>{c.voxel_bits, c.voxel_frac_bits, c.normal_bits,   c.matrix_frac_bits,
                               c.depth_bits, c.plane_log2,      c.en_vpu_offset, c.en_perspective,
                               c.sub_bits,   c.span_log2,       c.nodes_log2,    c.quads_log2};
  };
  const auto slb = [](const HardwareConfig& c) {
    return std::array<int, 6>{c.frac_bits,      c.slope_bits, c.frags_per_pixel,
                              c.slb_plane_log2, c.depth_bits, static_cast<int>(c.slb_rounding)};
  };
  const auto chosen = stimulus::covering_array();
  auto with_slb = chosen, with_topology = chosen, corners = stimulus::corner_configs();
  const auto topology_corners = stimulus::topology_corner_configs();
  std::erase_if(with_slb, [](const HardwareConfig& c) { return !c.en_slb; });
  std::erase_if(with_topology, [](const HardwareConfig& c) { return !c.en_vpu_topology; });
  const auto with_own_parameter = [](std::set<std::tuple<std::size_t, int, std::size_t, int>> all) {
    std::erase_if(all, [](const auto& pair) { return std::get<2>(pair) < 8; });
    return all;
  };
  EXPECT_EQ(with_own_parameter(pairs(with_topology, topology)),
            with_own_parameter(pairs(topology_corners, topology)));
  corners.insert(corners.end(), topology_corners.begin(), topology_corners.end());
  EXPECT_EQ(pairs(chosen, vpu), pairs(corners, vpu));
  EXPECT_EQ(pairs(with_slb, slb), pairs(stimulus::slb_corner_configs(), slb));
  EXPECT_LE(chosen.size(), 25u);
  EXPECT_EQ(chosen.front(), HardwareConfig{});
  EXPECT_EQ(chosen[1], HardwareConfig{.en_slb = true});
  for (const HardwareConfig& config : chosen) EXPECT_EQ(config.check(), std::nullopt);

  const auto ordered = stimulus::slb_covering_array();
  EXPECT_TRUE(std::is_permutation(ordered.begin(), ordered.end(), with_slb.begin(), with_slb.end()));
  const std::vector<HardwareConfig> half(ordered.begin(), ordered.begin() + 8);
  EXPECT_GE(pairs(half, slb).size() * 10, pairs(ordered, slb).size() * 7);
}

TEST(Covering, EveryPairOfValuesOfTheFrameBuffer) {
  const auto values = [](const HardwareConfig& c) {
    return std::array<int, 4>{c.voxel_bits, c.voxel_frac_bits, c.frame_layers_log2,
                              2 * c.en_vpu_topology + c.en_vpu_offset};
  };
  const auto configs = stimulus::frame_covering_array();
  EXPECT_EQ(pairs(configs, values).size(), 6u * 9u);  // six pairs of parameters, three values each
  for (const HardwareConfig& config : configs) {
    EXPECT_EQ(config.check(), std::nullopt);
    EXPECT_TRUE(config.en_frame_buffer);
  }
}

TEST(Covering, LargePlanesOfTheSilhouetteLineBuffer) {
  int plane_log2 = 9;
  for (const HardwareConfig& config : stimulus::large_slb_configs()) {
    EXPECT_EQ(config.check(), std::nullopt);
    EXPECT_EQ(config.slb_plane_log2, ++plane_log2);
  }
  EXPECT_EQ(plane_log2, 12);
}

}  // namespace
}  // namespace gnomon::golden_test
