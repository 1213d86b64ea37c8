// SPDX-License-Identifier: Apache-2.0
// Greedy pairwise covering: take the build that adds most pairs until none is missing.
#include "tests/support/covering.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <tuple>

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;

/// Two parameters and their values.
using Pair = std::tuple<std::size_t, int, std::size_t, int>;

std::array<int, 7> values(const HardwareConfig& c) {
  return {c.voxel_bits, c.voxel_frac_bits, c.normal_bits,  c.matrix_frac_bits,
          c.depth_bits, c.plane_log2,      c.en_vpu_offset};
}

std::vector<Pair> pairs(const HardwareConfig& config) {
  const auto value = values(config);
  std::vector<Pair> result;
  for (std::size_t i = 0; i < value.size(); ++i) {
    for (std::size_t j = i + 1; j < value.size(); ++j) result.emplace_back(i, value[i], j, value[j]);
  }
  return result;
}

std::ptrdiff_t missing_pairs(const HardwareConfig& config, const std::set<Pair>& missing) {
  const auto all = pairs(config);
  return std::count_if(all.begin(), all.end(), [&](const Pair& pair) { return missing.contains(pair); });
}

}  // namespace

std::vector<HardwareConfig> corner_configs() {
  std::vector<HardwareConfig> configs;
  for (const int voxel : {4, 8, 11})
    for (const int voxel_frac : {0, 2, 6})
      for (const int normal : {4, 9, 12})
        for (const int matrix_frac : {12, 22, 28})
          for (const int depth : {8, 20, 24})
            for (const int plane : {4, 9, 12})
              for (const bool offset : {true, false}) {
                const HardwareConfig config{voxel, voxel_frac, normal, matrix_frac, depth, plane, offset};
                if (!config.check()) configs.push_back(config);
              }
  return configs;
}

std::vector<HardwareConfig> covering_array() {
  const auto candidates = corner_configs();
  std::set<Pair> missing;
  for (const HardwareConfig& config : candidates) {
    for (const Pair& pair : pairs(config)) missing.insert(pair);
  }
  std::vector<HardwareConfig> chosen;
  HardwareConfig next;  // the default build
  while (!missing.empty()) {
    chosen.push_back(next);
    for (const Pair& pair : pairs(next)) missing.erase(pair);
    next = *std::max_element(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
      return missing_pairs(a, missing) < missing_pairs(b, missing);
    });
  }
  return chosen;
}

}  // namespace gnomon::stimulus
