// SPDX-License-Identifier: Apache-2.0
// Measures how good a set of voxels is. Used by the tests and by the program voxel_criteria.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::test {

/// One flag per voxel of the grid with a border of one empty voxel around it.
class DenseGrid {
 public:
  explicit DenseGrid(const voxel::VoxelSet& set);
  explicit DenseGrid(std::uint32_t res)
      : side_(std::int64_t{res} + 2), cells_(static_cast<std::size_t>(side_ * side_ * side_), 0) {}

  std::uint8_t& at(std::int64_t x, std::int64_t y, std::int64_t z) { return cells_[index(x, y, z)]; }
  std::uint8_t at(std::int64_t x, std::int64_t y, std::int64_t z) const { return cells_[index(x, y, z)]; }
  std::int64_t res() const { return side_ - 2; }

  /// What can be reached from outside through empty voxels, by steps to `neighbours` (6 or 26) voxels.
  DenseGrid outside(int neighbours) const;
  /// Every voxel whose 26-neighbourhood holds a set one.
  DenseGrid dilated() const;

 private:
  // Coordinates from -1 to res.
  std::size_t index(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>(((z + 1) * side_ + y + 1) * side_ + x + 1);
  }
  std::int64_t side_;
  std::vector<std::uint8_t> cells_;
};

/// The steps against which an adjacency must separate: 26-steps for N = 6, else 6-steps.
int crossing_steps(voxel::Adjacency adjacency);

/// What lies well away from the surface: enclosed even if the set is made one voxel thicker.
struct Separation {
  std::uint64_t inside = 0;  ///< voxels behind the normals
  std::uint64_t bays = 0;    ///< voxels before the normals: narrow bays of the outside
  std::uint64_t leaks = 0;   ///< of those inside, how many are reached from outside
};
/// Needs representatives, and faces that wind outwards.
Separation separation(const voxel::VoxelSet& set);

struct Coverage {
  std::uint64_t samples = 0;
  std::uint64_t uncovered = 0;  ///< samples without a set voxel within one voxel
  double own_voxel = 0;         ///< share of samples whose own voxel is set
  double farthest_centre = 0;   ///< largest distance of a set voxel's centre to the nearest sample, in voxels
};
/// Samples every face so densely that samples are less than `spacing` voxels apart.
Coverage coverage(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& set,
                  double spacing);

std::uint64_t duplicates(const voxel::VoxelSet& set);

/// Voxels that can be taken away, one after the other, without opening a way between inside and outside, as a
/// share of those that remain. Closed surfaces only.
double surplus(const voxel::VoxelSet& set);

}  // namespace gnomon::test
