// SPDX-License-Identifier: Apache-2.0
// Where things are and how large: bounds, the ground under the models, a camera that sees them.
#pragma once

#include <span>

#include "host/scene/scene.hpp"

namespace gnomon::scene {

/// The world's up direction.
Vec3 up_direction(UpAxis up);

/// From the upper left, in front of the models.
DirectionalLight default_light(UpAxis up);

/// A flat rectangle perpendicular to `up`, touching the lowest point of `models` (a box each) and large
/// enough for the shadows that `lights` cast; shadows longer than all models' size (grazing or low light) are
/// cut, because the larger the ground, the fewer voxels the models get. It is a subdivision surface itself: 4
/// x 4 quads whose border is infinitely sharp.
Object make_ground(std::span<const Box3> models, UpAxis up, std::span<const Light> lights);

/// A camera in front, to the right and above, far enough to see the models and a good part of the ground.
Camera fit_camera(const Box3& models, const Box3& all, UpAxis up, double image_aspect);

}  // namespace gnomon::scene
