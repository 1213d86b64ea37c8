// SPDX-License-Identifier: Apache-2.0
// Which combinations of axes' values are taken. Theory: docs/sweep.md, "Specification".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gnomon::sweep {

/// A combination: the index of the value taken on each axis.
using Combination = std::vector<std::size_t>;

/// How many combinations a grid has; saturates.
std::size_t grid_size(std::span<const std::size_t> values);

/// Every combination, the last axis fastest. `values`: how many each axis has.
std::vector<Combination> grid(std::span<const std::size_t> values);

/// `points` combinations, each value with equal chance, independently.
std::vector<Combination> random_sample(std::span<const std::size_t> values, std::size_t points,
                                       std::uint64_t seed);

/// `points` combinations; the values of every axis come equally often, but for one more where `points` does
/// not divide (McKay, Beckman and Conover 1979, on axes with a number of values each).
std::vector<Combination> latin_hypercube(std::span<const std::size_t> values, std::size_t points,
                                         std::uint64_t seed);

}  // namespace gnomon::sweep
