// SPDX-License-Identifier: Apache-2.0
// The plain shadow map that other techniques are measured against (docs/error-metrics.md, "Shadow map").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/base/vec.hpp"
#include "host/metrics/exact_reference.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

/// A square plane of pixels perpendicular to the light. Unit vectors in grid coordinates, pairwise
/// orthogonal; pixel (x, y) of point p is (right.p / pitch + x1, up.p / pitch + y1).
struct LightPlane {
  Vec3 right, up, away;  ///< `away`: the way the light travels
  double x1 = 0, y1 = 0;
  double pitch = 1;  ///< voxels per pixel
  int side = 0;      ///< pixels

  Vec2 pixel(const Vec3& p) const { return {right.dot(p) / pitch + x1, up.dot(p) / pitch + y1}; }
  /// The same area with `times` as many pixels on each side.
  LightPlane finer(int times) const {
    return {right, up, away, x1 * times, y1 * times, pitch / times, side * times};
  }
};

/// The nearest depth at each pixel's centre, exact (a ray each, cast when it is asked for, so that no
/// resolution is too high), compared with a slope-scaled bias. Thread-safe. `reference` must outlive it.
class ShadowMap {
 public:
  ShadowMap(const ExactReference& reference, const LightPlane& plane)
      : reference_(reference), plane_(plane) {}

  /// `facing`: cosine between normal and light; a surface that faces away is in shadow. Off the plane: lit.
  bool in_shadow(const Vec3& point, double facing) const;
  /// At all samples of the truth, on all cores.
  SampleAnswers answers(const ShadowTruth& truth) const;

 private:
  const ExactReference& reference_;
  LightPlane plane_;
};

}  // namespace gnomon::metrics
