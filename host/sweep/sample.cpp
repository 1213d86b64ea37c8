// SPDX-License-Identifier: Apache-2.0
// Samples of combinations. The standard library's distributions differ between libraries; what is drawn here
// does not.
#include "host/sweep/sample.hpp"

#include <limits>
#include <random>
#include <utility>

namespace gnomon::sweep {
namespace {

/// 0 .. below - 1, each equally likely.
std::size_t draw(std::mt19937_64& random, std::size_t below) {
  const std::uint64_t limit = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t usable = limit - limit % below;
  std::uint64_t value = random();
  while (value >= usable) value = random();
  return static_cast<std::size_t>(value % below);
}

void shuffle(std::vector<std::size_t>& list, std::mt19937_64& random) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[draw(random, i)]);
}

}  // namespace

std::size_t grid_size(std::span<const std::size_t> values) {
  std::size_t size = 1;
  for (const std::size_t count : values) {
    if (count != 0 && size > std::numeric_limits<std::size_t>::max() / count)
      return std::numeric_limits<std::size_t>::max();
    size *= count;
  }
  return size;
}

std::vector<Combination> grid(std::span<const std::size_t> values) {
  const std::size_t size = grid_size(values);
  std::vector<Combination> all;
  all.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    Combination combination(values.size());
    std::size_t rest = i;
    for (std::size_t axis = values.size(); axis-- > 0;) {
      combination[axis] = rest % values[axis];
      rest /= values[axis];
    }
    all.push_back(std::move(combination));
  }
  return all;
}

std::vector<Combination> random_sample(std::span<const std::size_t> values, std::size_t points,
                                       std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Combination> all(points, Combination(values.size()));
  for (Combination& combination : all) {
    for (std::size_t axis = 0; axis < values.size(); ++axis) combination[axis] = draw(random, values[axis]);
  }
  return all;
}

std::vector<Combination> latin_hypercube(std::span<const std::size_t> values, std::size_t points,
                                         std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Combination> all(points, Combination(values.size()));
  for (std::size_t axis = 0; axis < values.size(); ++axis) {
    // Which values come once more than the others is drawn, too.
    std::vector<std::size_t> order(values[axis]);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    shuffle(order, random);
    std::vector<std::size_t> column(points);
    for (std::size_t i = 0; i < points; ++i) column[i] = order[i % order.size()];
    shuffle(column, random);
    for (std::size_t i = 0; i < points; ++i) all[i][axis] = column[i];
  }
  return all;
}

}  // namespace gnomon::sweep
