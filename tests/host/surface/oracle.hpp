// SPDX-License-Identifier: Apache-2.0
// An independent limit surface: uniform refinement and Far's limit masks, without Bfr, patches or fits.
#pragma once

#include <vector>

#include "host/scene/control_mesh.hpp"

namespace gnomon::test {

/// A limit point and where it lies on its cage face: `corner` is the corner that (u, v) starts from, a quad
/// has 0 alone.
struct OraclePoint {
  int cage_face = 0;
  int corner = 0;
  double u = 0, v = 0;
  Vec3 position;
};

/// The corners of all faces of refinement level `level` (at most 15, no less than the largest finite
/// sharpness).
std::vector<OraclePoint> refine_to_limit(const scene::ControlMesh& mesh, int level);

/// The cage after `level` refinements, without creases: only for smooth closed cages.
scene::ControlMesh refined(const scene::ControlMesh& mesh, int level);

}  // namespace gnomon::test
