// SPDX-License-Identifier: Apache-2.0
// Remembers the voxels of border points, so that the second face that asks does not evaluate again.
#pragma once

#include <atomic>
#include <vector>

#include "host/surface/borders.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {

/// Safe from many threads. Two threads that miss at once compute the same value; one of them counts.
class BorderCache {
 public:
  explicit BorderCache(const surface::LimitSurface& surface);

  struct Answer {
    VoxelKey key;
    bool fresh;  ///< it had to be evaluated
  };
  /// `u` or `v` must be 0 or 1.
  Answer voxel(std::uint32_t face, double u, double v, std::uint32_t res);

 private:
  std::atomic<VoxelKey>* slot(const surface::BorderSpot& spot);

  struct Curve {
    std::size_t first;
    double steps;
  };
  const surface::LimitSurface& surface_;
  std::vector<Curve> curves_;
  std::vector<std::atomic<VoxelKey>> slots_;  // vertices, then curves; 0 is empty, otherwise key + 1
};

}  // namespace gnomon::voxel
