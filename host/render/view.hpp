// SPDX-License-Identifier: Apache-2.0
// From where a scene is looked at, and what its objects look like.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/vec.hpp"

namespace gnomon::render {

/// A pinhole camera, in grid coordinates.
struct Camera {
  Vec3 eye{0, 0, 1}, target{0, 0, 0}, up{0, 1, 0};
  double fov_degrees = 35;  ///< vertical field of view, 0 < fov < 180
};

/// `frames` cameras that go once around the target in equal steps, about the axis `up` through it and
/// anticlockwise seen from its tip; the first is `start` itself. They do not end where they began.
std::vector<Camera> full_turn(const Camera& start, std::size_t frames);

/// Colours are linear RGB, 0..1.
struct Material {
  std::array<float, 3> diffuse{0.6f, 0.6f, 0.6f};
  float specular = 0.25f;
  float shininess = 40;  ///< Blinn-Phong exponent
};

/// Light grey for `ground` (pass the object count or more for none), warm and well separated colours for the
/// others.
std::vector<Material> default_materials(std::uint32_t objects, std::uint32_t ground);

}  // namespace gnomon::render
