// SPDX-License-Identifier: Apache-2.0
// Greedy pairwise covering: take the build that adds most pairs until none is missing. The units' parameters
// are chosen one unit after the other, so that the candidates stay few.
#include "tests/support/covering.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using Configs = std::vector<HardwareConfig>;

constexpr int kAbsent = -1, kHighestValue = 31;
/// One unit's parameters, each always in the same place; kAbsent where hardware does not have it.
using Values = std::array<int, 13>;

Values vpu_values(const HardwareConfig& c) {
  Values values{c.voxel_bits, c.voxel_frac_bits, c.normal_bits,    c.matrix_frac_bits, c.depth_bits,
                c.plane_log2, c.en_vpu_offset,   c.en_perspective, c.en_vpu_topology,  kAbsent,
                kAbsent,      kAbsent,           kAbsent};
  if (!c.en_vpu_topology) return values;
  const std::array topology{c.sub_bits, c.span_log2, c.nodes_log2, c.quads_log2};
  std::copy(topology.begin(), topology.end(), values.end() - topology.size());
  return values;
}

int fewest_subpixel_bits(const HardwareConfig& c) {
  return std::max(c.frac_bits + 3, c.slope_bits - c.frac_bits + 4);
}
/// Of a coordinate: what the word and the range allow.
int most_fraction_bits(const HardwareConfig& c) {
  return std::min(16, (64 - c.depth_bits) / 2 - c.slb_plane_log2 - 2);
}

/// Fraction bits count as fewest or more; what they are depends on the others.
Values slb_values(const HardwareConfig& c) {
  return {c.frac_bits,
          c.slope_bits,
          c.frags_per_pixel,
          c.slb_plane_log2,
          c.depth_bits,
          c.subpixel_bits > fewest_subpixel_bits(c),
          c.query_bits > c.frac_bits + 3,
          static_cast<int>(c.slb_rounding),
          kAbsent,
          kAbsent,
          kAbsent,
          kAbsent,
          kAbsent};
}

/// What is still to be covered in one unit: a table of all pairs of two parameters' values.
class Missing {
 public:
  using ValuesOf = Values (*)(const HardwareConfig&);

  Missing(ValuesOf values, const Configs& candidates) : values_(values), pairs_(kCodes * kCodes) {
    for (const HardwareConfig& config : candidates) set(config, true);
  }
  bool empty() const { return std::find(pairs_.begin(), pairs_.end(), 1) == pairs_.end(); }
  void remove(const HardwareConfig& config) { set(config, false); }
  /// The first candidate among those that cover most.
  HardwareConfig best(const Configs& candidates) const {
    const HardwareConfig* chosen = nullptr;
    int most = -1;
    for (const HardwareConfig& config : candidates) {
      const int covered = covers(config);
      if (covered > most) chosen = &config;
      most = std::max(most, covered);
    }
    return *chosen;
  }

 private:
  static constexpr std::size_t kCodes = std::tuple_size_v<Values> * (kHighestValue + 1);

  /// Calls `visit` with the place of each of its pairs in the table.
  template <typename Visit>
  void for_pairs(const HardwareConfig& config, const Visit& visit) const {
    const Values values = values_(config);
    std::array<std::size_t, std::tuple_size_v<Values>> codes{};
    std::size_t present = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] != kAbsent)
        codes[present++] = i * (kHighestValue + 1) + static_cast<std::size_t>(values[i]);
    }
    for (std::size_t i = 0; i < present; ++i)
      for (std::size_t j = i + 1; j < present; ++j) visit(codes[i] * kCodes + codes[j]);
  }
  void set(const HardwareConfig& config, bool missing) {
    for_pairs(config, [&](std::size_t pair) { pairs_[pair] = missing ? 1 : 0; });
  }
  int covers(const HardwareConfig& config) const {
    int count = 0;
    for_pairs(config, [&](std::size_t pair) { count += pairs_[pair]; });
    return count;
  }

  ValuesOf values_;
  std::vector<char> pairs_;
};

/// The projection unit of the one, the silhouette-line buffer of the other.
HardwareConfig joined(HardwareConfig vpu, const HardwareConfig& slb) {
  vpu.en_slb = true;
  vpu.slb_plane_log2 = slb.slb_plane_log2;
  vpu.frac_bits = slb.frac_bits;
  vpu.slope_bits = slb.slope_bits;
  vpu.frags_per_pixel = slb.frags_per_pixel;
  vpu.subpixel_bits = slb.subpixel_bits;
  vpu.query_bits = slb.query_bits;
  vpu.slb_rounding = slb.slb_rounding;
  return vpu;
}

Configs with_depth(const Configs& configs, int depth) {
  Configs chosen;
  std::copy_if(configs.begin(), configs.end(), std::back_inserter(chosen),
               [&](const HardwareConfig& config) { return config.depth_bits == depth; });
  return chosen;
}

void add_fraction_bits(Configs& configs, HardwareConfig config) {
  const int most = most_fraction_bits(config);
  for (const int subpixel : {fewest_subpixel_bits(config), most})
    for (const int query : {config.frac_bits + 3, most})
      for (const golden::slb::Rounding rounding :
           {golden::slb::Rounding::Better, golden::slb::Rounding::Published}) {
        config.subpixel_bits = subpixel;
        config.query_bits = query;
        config.slb_rounding = rounding;
        if (!config.check()) configs.push_back(config);
      }
}

Configs make_covering_array() {
  const Configs slb_candidates = slb_corner_configs(), with_topology = topology_corner_configs();
  Configs vpu_candidates = corner_configs();
  vpu_candidates.insert(vpu_candidates.end(), with_topology.begin(), with_topology.end());
  Missing vpu(vpu_values, vpu_candidates), slb(slb_values, slb_candidates);
  Configs chosen;
  const auto choose = [&](const HardwareConfig& config) {
    chosen.push_back(config);
    vpu.remove(config);
    if (config.en_slb) slb.remove(config);
  };
  choose({});
  choose({.en_slb = true});
  choose({.en_vpu_offset = false});
  while (!vpu.empty()) {
    const HardwareConfig next = vpu.best(vpu_candidates);
    choose(joined(next, slb.best(with_depth(slb_candidates, next.depth_bits))));
  }
  while (!slb.empty()) choose(slb.best(slb_candidates));
  return chosen;
}

}  // namespace

Configs corner_configs() {
  Configs configs;
  for (const int voxel : {4, 8, 11})
    for (const int voxel_frac : {0, 2, 6})
      for (const int normal : {4, 9, 12})
        for (const int matrix_frac : {12, 22, 28})
          for (const int depth : {8, 20, 24})
            for (const int plane : {4, 9, 12})
              for (const bool offset : {true, false})
                for (const bool perspective : {false, true}) {
                  HardwareConfig config{voxel, voxel_frac, normal, matrix_frac, depth, plane, offset};
                  config.en_perspective = perspective;
                  if (!config.check()) configs.push_back(config);
                }
  return configs;
}

/// Topology mode's parameters in the rows of the orthogonal array of four with three values each.
Configs topology_corner_configs() {
  constexpr std::array kSub{2, 4, 8}, kSpan{2, 4, 6}, kNodes{4, 20, 24}, kQuads{4, 18, 24};
  Configs configs;
  for (HardwareConfig config : corner_configs()) {
    config.en_vpu_topology = true;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        config.sub_bits = kSub.at(i);
        config.span_log2 = kSpan.at(j);
        config.nodes_log2 = kNodes.at((i + j) % 3);
        config.quads_log2 = kQuads.at((i + 2 * j) % 3);
        configs.push_back(config);
      }
    }
  }
  return configs;
}

Configs slb_corner_configs() {
  Configs configs;
  for (const int frac : {3, 7, 8})
    for (const int slope : {3, 7, 9})
      for (const int frags : {1, 2, 4})
        for (const int plane : {3, 8, 9})
          for (const int depth : {8, 20, 24}) {
            HardwareConfig config;
            config.en_slb = true;
            config.frac_bits = frac;
            config.slope_bits = slope;
            config.frags_per_pixel = frags;
            config.slb_plane_log2 = plane;
            config.depth_bits = depth;
            add_fraction_bits(configs, config);
          }
  return configs;
}

Configs covering_array() {
  static const Configs all = make_covering_array();
  return all;
}

Configs slb_covering_array() {
  Configs left = covering_array(), ordered;
  std::erase_if(left, [](const HardwareConfig& config) { return !config.en_slb; });
  Missing missing(slb_values, left);
  while (!left.empty()) {
    ordered.push_back(missing.best(left));
    missing.remove(ordered.back());
    std::erase(left, ordered.back());
  }
  return ordered;
}

/// The orthogonal array of four parameters with three values each: column c of row 3 i + j is i, j, i + j or
/// i + 2 j, modulo 3.
Configs frame_covering_array() {
  constexpr std::array kVoxelBits{4, 5, 7}, kFractionBits{0, 2, 6}, kLayers{0, 1, 3};
  Configs configs;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t modes = (i + 2 * j) % 3;  // offset, topology, both
      HardwareConfig config{.plane_log2 = 4, .nodes_log2 = 10, .quads_log2 = 8, .en_frame_buffer = true};
      config.voxel_bits = kVoxelBits.at(i);
      config.voxel_frac_bits = kFractionBits.at(j);
      config.normal_bits = 7;
      config.frame_layers_log2 = kLayers.at((i + j) % 3);
      config.en_vpu_offset = modes != 1;
      config.en_vpu_topology = modes != 0;
      configs.push_back(config);
    }
  }
  return configs;
}

HardwareConfig large_frame_config() {
  return {.plane_log2 = 4,
          .en_vpu_topology = true,
          .nodes_log2 = 10,
          .quads_log2 = 8,
          .en_frame_buffer = true,
          .frame_layers_log2 = 3};
}

Configs large_slb_configs() {
  const HardwareConfig base{.depth_bits = 18, .plane_log2 = 4, .en_slb = true};
  HardwareConfig high = base, middle = base, low = base;
  high.slb_plane_log2 = 10;
  high.frac_bits = 8;
  high.slope_bits = 9;
  high.frags_per_pixel = 4;
  high.subpixel_bits = high.query_bits = 11;
  middle.slb_plane_log2 = 11;
  low.slb_plane_log2 = 12;
  low.frac_bits = low.slope_bits = 3;
  low.frags_per_pixel = 1;
  low.subpixel_bits = low.query_bits = 9;
  low.slb_rounding = golden::slb::Rounding::Published;
  return {high, middle, low};
}

}  // namespace gnomon::stimulus
