// SPDX-License-Identifier: Apache-2.0
// A sorted list of (cell, answer); a row of three cells is one search.
#include "host/metrics/cell_answers.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace gnomon::metrics {
namespace {

constexpr unsigned kLit = 1;
constexpr unsigned kDark = 2;

/// Cell coordinates, x fastest, and the answer in the lowest bit. One is added so that -1 is a cell too.
std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z, bool dark) {
  const std::int64_t cell = ((z + 1) << 42) | ((y + 1) << 21) | (x + 1);
  return (static_cast<std::uint64_t>(cell) << 1) | (dark ? 1u : 0u);
}

std::int64_t floor_of(double value) {
  return static_cast<std::int64_t>(std::floor(value));
}

unsigned answers_in_row(const std::vector<std::uint64_t>& sorted, int x, int y, int z) {
  unsigned seen = 0;
  const std::uint64_t last = key(x + 1, y, z, true);
  for (auto at = std::lower_bound(sorted.begin(), sorted.end(), key(x - 1, y, z, false));
       at != sorted.end() && *at <= last; ++at)
    seen |= (*at & 1u) != 0 ? kDark : kLit;
  return seen;
}

}  // namespace

std::vector<std::uint8_t> unambiguous_voxels(const voxel::VoxelSet& voxels,
                                             std::span<const Exact> voxel_answers,
                                             std::span<const std::uint8_t> receives,
                                             std::span<const SurfaceSample> samples,
                                             std::span<const Vec3> border) {
  std::vector<std::uint64_t> seen(samples.size());
  tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
    const SurfaceSample& s = samples[i];
    seen[i] = key(floor_of(double{s.x}), floor_of(double{s.y}), floor_of(double{s.z}), in_shadow(s.exact));
  });
  for (std::size_t i = 0; i < voxel_answers.size(); ++i) {
    const voxel::Voxel& v = voxels.voxels[i];
    if (receives[v.object] != 0) seen.push_back(key(v.x, v.y, v.z, in_shadow(voxel_answers[i])));
  }
  for (const Vec3& p : border)
    for (const bool dark : {false, true})
      seen.push_back(key(floor_of(p.x), floor_of(p.y), floor_of(p.z), dark));
  tbb::parallel_sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  std::vector<std::uint8_t> result(voxels.voxels.size());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
    const voxel::Voxel& v = voxels.voxels[i];
    if (receives[v.object] == 0) return;
    unsigned around = 0;
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy) around |= answers_in_row(seen, v.x, v.y + dy, v.z + dz);
    result[i] = around == kLit || around == kDark ? 1 : 0;
  });
  return result;
}

}  // namespace gnomon::metrics
