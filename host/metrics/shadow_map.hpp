// SPDX-License-Identifier: Apache-2.0
// The plain shadow map that other techniques are measured against (docs/error-metrics.md, "Shadow map").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/base/light_plane.hpp"
#include "host/metrics/exact_reference.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

/// The nearest depth at each pixel's centre, exact (a ray each, cast when it is asked for, so that no
/// resolution is too high), compared with a slope-scaled bias. Thread-safe. `reference` must outlive it.
class ShadowMap {
 public:
  /// Throws std::invalid_argument for a light that is not directional.
  ShadowMap(const ExactReference& reference, const LightPlane& plane);

  /// `facing`: cosine between normal and light; a surface that faces away is in shadow. Off the plane: lit.
  bool in_shadow(const Vec3& point, double facing) const;
  /// At the voxels' representatives. `two_sided[object]` as in ExactReference.
  std::vector<golden::VoxelState> states(const voxel::VoxelSet& voxels,
                                         const std::vector<bool>& two_sided) const;
  /// At all samples of the truth, on all cores.
  SampleAnswers answers(const ShadowTruth& truth) const;

 private:
  const ExactReference& reference_;
  LightPlane plane_;
};

}  // namespace gnomon::metrics
