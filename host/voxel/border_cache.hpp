// SPDX-License-Identifier: Apache-2.0
// Remembers the voxels of border points, so that the second face that asks does not evaluate again.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
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

  /// The memory of equally spaced points on one side of a face: point i is at first[i * stride].
  struct Stretch {
    std::atomic<VoxelKey>* first = nullptr;  ///< null: not all of the points are remembered
    std::ptrdiff_t stride = 0;
    bool own = false;  ///< they are evaluated where they were asked for, in this face

    /// What voxel() would say, if it has been asked before.
    std::optional<VoxelKey> recall(std::ptrdiff_t i) const {
      if (first == nullptr) return std::nullopt;
      const VoxelKey k = first[i * stride].load(std::memory_order_relaxed);
      return k == 0 ? std::nullopt : std::optional(k - 1);
    }
    /// For points of its own: false if another thread was faster.
    bool remember(std::ptrdiff_t i, VoxelKey key) const {
      VoxelKey empty = 0;
      return first[i * stride].compare_exchange_strong(empty, key + 1, std::memory_order_relaxed);
    }
  };
  /// Points (u, v) + i (du, dv), for i from 1 on, that are not corners of the face.
  Stretch stretch(std::uint32_t face, double u, double v, double du, double dv);

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
