// SPDX-License-Identifier: Apache-2.0
#include "tests/support/box_size.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace gnomon::stimulus {

namespace {

using golden::perspective::View;
using golden::topology::Corner;
using golden::topology::Item;
using golden::topology::ProjectionRegisters;
using golden::topology::TopologyConfig;
using golden::topology::Word;

/// Entries from the lowest to the highest of some sub-entries, without those beyond the plane.
struct Range {
  std::int64_t low = std::numeric_limits<std::int64_t>::max(),
               high = std::numeric_limits<std::int64_t>::min();

  void add(std::int64_t sub_entries) {
    low = std::min(low, sub_entries);
    high = std::max(high, sub_entries);
  }
  std::int64_t size(const TopologyConfig& config) const {
    const std::int64_t first = std::max<std::int64_t>(low >> config.sub_bits, 0);
    const std::int64_t last = std::min(high >> config.sub_bits, config.side() - 1);
    return std::max<std::int64_t>(last - first + 1, 0);
  }
};

std::int64_t along(const std::array<std::int64_t, 12>& matrix, std::size_t row, const Item& item) {
  std::int64_t sum = matrix[4 * row + 3];
  for (std::size_t i = 0; i < 3; ++i) sum += matrix[4 * row + i] * item.position[i];
  return sum;
}

}  // namespace

std::int64_t box_size(std::span<const Word, golden::topology::kWordsPerQuad> corners,
                      const ProjectionRegisters& light, const TopologyConfig& config) {
  const View view({.position_bits = config.position_bits(),
                   .matrix_frac_bits = config.matrix_frac_bits,
                   .depth_bits = config.depth_bits,
                   .plane_log2 = config.plane_log2},
                  light.perspective);
  Range u, v;
  for (const Word word : corners) {
    const Item item = golden::topology::decode_item(word, config);
    const std::int64_t u_acc = along(light.matrix, 0, item), v_acc = along(light.matrix, 1, item);
    Corner corner = land_corner({.u = u_acc, .v = v_acc, .d = 0}, config);
    if (light.perspective.perspective) {
      const auto sight = view.see(u_acc, v_acc, item.position);
      if (sight.behind) return 0;  // such a quad is not linked at all
      corner = land_corner(sight, config);
    }
    u.add(corner.u);
    v.add(corner.v);
  }
  return u.size(config) * v.size(config);
}

}  // namespace gnomon::stimulus
