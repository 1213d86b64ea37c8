// SPDX-License-Identifier: Apache-2.0
// Disjoint sets of numbers.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace gnomon::outline {

/// Numbers 0..n-1, each a set of its own until joined.
class Partition {
 public:
  explicit Partition(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  /// The smallest number of i's set.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) {
      parent_[b] = a;
    } else {
      parent_[a] = b;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace gnomon::outline
