// SPDX-License-Identifier: Apache-2.0
// From cages to voxels in one call, for the tests of this folder.
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "cages.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon::test {

/// With the control points `margin` voxels inside the grid.
inline std::vector<surface::LimitSurface> fitted(const std::vector<scene::ControlMesh>& meshes, double res,
                                                 double margin) {
  std::vector<surface::LimitSurface> out;
  for (const auto& m : meshes) {
    auto s = surface::LimitSurface::build(m, fit_to_grid(meshes, res, margin));
    if (!s) throw std::runtime_error(s.error().message);
    out.push_back(std::move(*s));
  }
  return out;
}

inline std::vector<surface::LimitSurface> surfaces_of(const std::vector<scene::ControlMesh>& meshes,
                                                      double res) {
  return fitted(meshes, res, 2);
}

inline voxel::Grid grid_of(std::uint32_t res, voxel::Adjacency adjacency) {
  voxel::Grid g;
  g.res = res;
  g.adjacency = adjacency;
  return g;
}

inline voxel::VoxelSet run(const std::vector<surface::LimitSurface>& s, std::uint32_t res, voxel::Adjacency a,
                           const voxel::VoxelizerOptions& o = {}) {
  auto set = voxel::voxelize(s, grid_of(res, a), o);
  if (!set) throw std::runtime_error(set.error().message);
  return std::move(*set);
}

inline voxel::VoxelSet voxels_of(const scene::ControlMesh& mesh, std::uint32_t res, voxel::Adjacency a,
                                 const voxel::VoxelizerOptions& o = {}) {
  return run(surfaces_of({mesh}, res), res, a, o);
}

}  // namespace gnomon::test
