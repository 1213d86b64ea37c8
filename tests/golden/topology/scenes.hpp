// SPDX-License-Identifier: Apache-2.0
// Small configurations, registers and random quads for the tests of topology mode.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <gnomon/golden/topology/unit.hpp>
#include <vector>

#include "tests/support/random.hpp"

namespace gnomon::test {

using golden::topology::Item;
using golden::topology::ProjectionRegisters;
using golden::topology::TopologyConfig;
using golden::topology::Word;
using Quad = std::array<Item, 4>;

/// 16 voxels, 16 x 16 entries.
inline TopologyConfig small_config() {
  TopologyConfig config;
  config.voxel_bits = 4;
  config.plane_log2 = 4;
  config.nodes_log2 = 12;
  config.quads_log2 = 10;
  return config;
}

/// Light along -z, one entry a voxel. At ulp (x, y, z) it gives entry (x + 1/2, y + 1/2) / 2^F and depth
/// (15 * 2^F + 1 - z) * 1000 / 2^F.
inline ProjectionRegisters from_above(const TopologyConfig& config) {
  const int frac = config.voxel_frac_bits, f = config.matrix_frac_bits;
  const std::int64_t entry = std::int64_t{1} << (f - frac);
  const std::int64_t code = std::int64_t{1000} << (config.position_bits() + 4 - frac);
  ProjectionRegisters registers;
  registers.matrix = {entry, 0,         0, entry / 2, 0,     entry,
                      0,     entry / 2, 0, 0,         -code, (code << frac) * 15 + code};
  return registers;
}

/// A grid point; ulps. The normal looks up.
inline Item at(const TopologyConfig& config, double x, double y, double z) {
  const double scale = 1 << config.voxel_frac_bits;
  Item item;
  item.position = {static_cast<std::uint32_t>(x * scale), static_cast<std::uint32_t>(y * scale),
                   static_cast<std::uint32_t>(z * scale)};
  item.normal = {0, 0, (1 << (config.normal_bits - 1)) - 1};
  return item;
}

/// An axis-parallel square at height z.
inline Quad square(const TopologyConfig& config, double x, double y, double size, double z) {
  return {at(config, x, y, z), at(config, x + size, y, z), at(config, x + size, y + size, z),
          at(config, x, y + size, z)};
}

/// The item's word (docs/command-stream.md, "Voxel item").
inline Word word_of(const Item& item, const TopologyConfig& config) {
  const int p = config.position_bits(), n = config.normal_bits;
  Word word = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    word |= Word{item.position[i]} << (axis * p);
    const Word normal = static_cast<Word>(item.normal[i]) & ((Word{1} << n) - 1);
    word |= normal << (3 * p + axis * n);
  }
  return word;
}

inline Item random_item(stimulus::Random& random, const TopologyConfig& config) {
  Item item;
  for (std::size_t i = 0; i < 3; ++i) {
    item.position[i] = static_cast<std::uint32_t>(random.between(0, (1 << config.position_bits()) - 1));
    const int most = (1 << (config.normal_bits - 1)) - 1;
    item.normal[i] = static_cast<std::int32_t>(random.between(-most, most));
  }
  return item;
}

/// Corners within `reach` ulps of a random place; now and then two of them are one.
inline Quad random_quad(stimulus::Random& random, const TopologyConfig& config, int reach) {
  const Item middle = random_item(random, config);
  const std::int64_t last = (1 << config.position_bits()) - 1;
  Quad quad;
  for (Item& corner : quad)
    for (std::size_t i = 0; i < 3; ++i)
      corner.position[i] = static_cast<std::uint32_t>(
          std::clamp<std::int64_t>(middle.position[i] + random.between(-reach, reach), 0, last));
  if (random.chance(20)) quad[3] = quad[2];
  return quad;
}

/// Any light: rows of random coefficients of a sensible size.
inline ProjectionRegisters random_registers(stimulus::Random& random, const TopologyConfig& config) {
  const std::int64_t entry = std::int64_t{1} << (config.matrix_frac_bits - config.voxel_frac_bits);
  const std::int64_t code = std::int64_t{1} << (config.depth_bits + 3);
  ProjectionRegisters registers;
  for (std::size_t row = 0; row < 3; ++row) {
    const std::int64_t size = row < 2 ? entry : code;
    for (std::size_t i = 0; i < 3; ++i) registers.matrix[4 * row + i] = random.between(-size, size);
  }
  const std::int64_t middle = std::int64_t{1} << (config.plane_log2 - 1);
  for (std::size_t row = 0; row < 2; ++row) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += registers.matrix[4 * row + i];
    registers.matrix[4 * row + 3] =
        (middle << config.matrix_frac_bits) - (sum << (config.position_bits() - 1));
  }
  registers.matrix[11] = std::int64_t{1} << (config.depth_bits + config.position_bits() + 3);
  registers.offset_factor = random.between(0, 400);
  return registers;
}

}  // namespace gnomon::test
