// SPDX-License-Identifier: Apache-2.0
// Vectors, boxes and matrices of the host: Imath's, in double precision.
#pragma once

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

namespace gnomon {

using Vec2 = Imath::V2d;
using Vec3 = Imath::V3d;
using Box3 = Imath::Box3d;
/// Imath's convention: points are row vectors, p' = p * M.
using Mat4 = Imath::M44d;

}  // namespace gnomon
