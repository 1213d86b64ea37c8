// SPDX-License-Identifier: Apache-2.0
// What the exact reference says about a voxelized scene: per voxel, per surface sample, and where the
// shadows' borders run.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "host/metrics/exact_reference.hpp"
#include "host/metrics/progress.hpp"
#include "host/metrics/voxel_index.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::metrics {

struct TruthOptions {
  double spacing = 0.5;                       ///< voxels: sides of the rectangles that have one sample each
  std::function<void(double done)> progress;  ///< called with 0..1, one call at a time; may be empty
  std::function<bool()> cancelled;            ///< polled; true makes it end with Cancelled; may be empty
};

/// One sample, somewhere in its small rectangle of parameter space.
struct SurfaceSample {
  float x, y, z;        ///< grid coordinates
  float light_area;     ///< the rectangle's area as the light sees it (LightScale)
  float facing;         ///< cosine between normal and light, negative where the surface faces away
  std::uint32_t voxel;  ///< the set voxel whose state answers here: its own, else the nearest set neighbour;
                        ///< kNoVoxel if none
  std::uint16_t object;
  Exact exact;
};

/// Length of the exact shadow's border as the light sees it (LightScale).
struct BorderLength {
  double cast = 0;      ///< between lit surface and shadow cast on it, and along the edge of a spot's cone
  double attached = 0;  ///< terminators: between lit surface and surface that faces away
  double total() const { return cast + attached; }
  friend BorderLength operator+(const BorderLength& a, const BorderLength& b) {
    return {a.cast + b.cast, a.attached + b.attached};
  }
};

/// A rectangle that the border crosses is divided into this many on each side.
inline constexpr std::uint32_t kBorderSplit = 8;

struct ShadowTruth {
  std::vector<Exact> voxels;  ///< at each voxel's representative point
  /// 1 where the voxel's cell and its 26 neighbours hold one answer only; 0 on objects that do not receive.
  std::vector<std::uint8_t> unambiguous;
  /// 1 where it is unambiguous and does not hang on a fraction of a voxel (steady_voxels.hpp).
  std::vector<std::uint8_t> steady;
  std::vector<std::uint8_t> receives;  ///< by object: 0 has no samples and counts in no figure
  std::vector<SurfaceSample> samples;
  /// 1 for the samples whose rectangle the exact border crosses: areas there are measured by border_samples.
  std::vector<std::uint8_t> on_border;
  /// kBorderSplit^2 samples for each rectangle that the border crosses, so that a displacement far below the
  /// rectangles' size shows.
  std::vector<SurfaceSample> border_samples;
  std::vector<BorderLength> border;  ///< by object that receives the shadow
  std::uint64_t rays = 0;
  double seconds = 0;  ///< wall time
  double sag = 0;      ///< voxels, of the reference used
};

/// `surfaces` must be the ones that `voxels` was made from (with representatives). Multithreaded,
/// deterministic.
ShadowTruth shadow_truth(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
                         const voxel::VoxelSet& voxels, const TruthOptions& options = {});

}  // namespace gnomon::metrics
