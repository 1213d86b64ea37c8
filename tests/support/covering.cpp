// SPDX-License-Identifier: Apache-2.0
// Greedy pairwise covering: take the build that adds most pairs until none is missing. The units' parameters
// are chosen one unit after the other, so that the candidates stay few.
#include "tests/support/covering.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <set>
#include <tuple>

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using Configs = std::vector<HardwareConfig>;

/// Two parameters and their values.
using Pair = std::tuple<std::size_t, int, std::size_t, int>;
using Pairs = std::set<Pair>;

std::vector<int> vpu_values(const HardwareConfig& c) {
  return {c.voxel_bits, c.voxel_frac_bits, c.normal_bits,   c.matrix_frac_bits,
          c.depth_bits, c.plane_log2,      c.en_vpu_offset, c.en_perspective};
}

int fewest_subpixel_bits(const HardwareConfig& c) {
  return std::max(c.frac_bits + 3, c.slope_bits - c.frac_bits + 4);
}
/// Of a coordinate: what the word and the range allow.
int most_fraction_bits(const HardwareConfig& c) {
  return std::min(16, (64 - c.depth_bits) / 2 - c.slb_plane_log2 - 2);
}

/// Fraction bits count as fewest or more; what they are depends on the others.
std::vector<int> slb_values(const HardwareConfig& c) {
  return {c.frac_bits,
          c.slope_bits,
          c.frags_per_pixel,
          c.slb_plane_log2,
          c.depth_bits,
          c.subpixel_bits > fewest_subpixel_bits(c),
          c.query_bits > c.frac_bits + 3,
          static_cast<int>(c.slb_rounding)};
}

Pairs pairs(const std::vector<int>& values) {
  Pairs result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = i + 1; j < values.size(); ++j) result.emplace(i, values[i], j, values[j]);
  }
  return result;
}

using Values = std::vector<int> (*)(const HardwareConfig&);

/// What is still to be covered in one unit.
class Missing {
 public:
  Missing(Values values, const Configs& candidates) : values_(values) {
    for (const HardwareConfig& config : candidates) pairs_.merge(pairs(values(config)));
  }
  bool empty() const { return pairs_.empty(); }
  void remove(const HardwareConfig& config) {
    for (const Pair& pair : pairs(values_(config))) pairs_.erase(pair);
  }
  /// The first candidate among those that cover most.
  HardwareConfig best(const Configs& candidates) const {
    return *std::max_element(candidates.begin(), candidates.end(),
                             [&](const auto& a, const auto& b) { return covers(a) < covers(b); });
  }

 private:
  std::ptrdiff_t covers(const HardwareConfig& config) const {
    const Pairs all = pairs(values_(config));
    return std::count_if(all.begin(), all.end(), [&](const Pair& pair) { return pairs_.contains(pair); });
  }

  Values values_;
  Pairs pairs_;
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
  const Configs slb_candidates = slb_corner_configs(), vpu_candidates = corner_configs();
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
