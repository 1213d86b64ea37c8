// SPDX-License-Identifier: Apache-2.0
// Cages and lights that outlines are tested with.
#pragma once

#include <string>
#include <vector>

#include "cages.hpp"
#include "host/outline/outline.hpp"

namespace gnomon::outline::test {

struct Case {
  std::string name;
  bool open;  ///< not a closed surface: both sides cast
  scene::ControlMesh mesh;
};

/// Closed, open, creased, with holes, non-manifold, unorientable.
std::vector<Case> all_cases();

/// A cube with `sharpness` on all edges.
scene::ControlMesh box(float sharpness);
/// A box without its top, smooth.
scene::ControlMesh cup();
/// One flat quad, one flat n-gon.
scene::ControlMesh plate();
/// A band of 8 quads, turned over once.
scene::ControlMesh moebius();

/// A light for tests, given in the meshes' own coordinates.
struct Light {
  std::string name;
  Vec3 direction;
};
/// Oblique, along axes, along the diagonals, and almost along an axis.
std::vector<Light> all_lights();

/// The view along `light` in which the box's diagonal measures `pixels`, its middle at (pixels/2, pixels/2).
/// Depth: as many codes as pixels, times 100.
LightFrame view_along(const Vec3& light, const Box3& box, double pixels, bool mirrored = false);

/// The cage's limit surface, coordinates times `scale`. Throws if there is none. At scale 1 the cages here
/// are too small for polynomials to be fitted to irregular faces, at 100 they are not.
surface::LimitSurface limit_of(const scene::ControlMesh& mesh, double scale = 100);
Box3 box_of(const scene::ControlMesh& mesh);

/// The outlines of one surface. Throws if there are none.
ObjectOutline outline_of(const surface::LimitSurface& surface, const LightFrame& frame,
                         const Options& options = {});

}  // namespace gnomon::outline::test
