// SPDX-License-Identifier: Apache-2.0
// How large a limit surface is: its control points reach farther than it does.
#pragma once

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/scene/control_mesh.hpp"

namespace gnomon::scene {

/// Box of the control points: always holds the limit surface.
Box3 hull_bounds(const ControlMesh& mesh, const Mat4& to_world);

/// Box of the limit surface, from inside, to about 1e-9 of its size: samples of every face, then a local
/// search around the most extreme ones. Cages of more than 100,000 faces get hull_bounds, which there differs
/// by little.
Result<Box3> limit_bounds(const ControlMesh& mesh, const Mat4& to_world);

}  // namespace gnomon::scene
