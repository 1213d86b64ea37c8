// SPDX-License-Identifier: Apache-2.0
// The palette.
#include "host/render/view.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace gnomon::render {
namespace {

constexpr std::array<std::array<float, 3>, 7> kWarm = {{
    {0.72f, 0.29f, 0.14f},  // terracotta
    {0.83f, 0.56f, 0.16f},  // ochre
    {0.62f, 0.17f, 0.17f},  // brick
    {0.78f, 0.45f, 0.38f},  // salmon
    {0.45f, 0.25f, 0.14f},  // umber
    {0.86f, 0.70f, 0.42f},  // sand
    {0.55f, 0.20f, 0.32f},  // plum
}};

}  // namespace

std::vector<Camera> full_turn(const Camera& start, std::size_t frames) {
  std::vector<Camera> cameras(frames, start);
  const Vec3 axis = start.up.normalized();
  const Vec3 arm = start.eye - start.target;
  const Vec3 along = axis * arm.dot(axis);
  const Vec3 across = arm - along;
  for (std::size_t i = 1; i < frames; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(frames);
    cameras[i].eye = start.target + along + across * std::cos(angle) + axis.cross(across) * std::sin(angle);
  }
  return cameras;
}

std::vector<Material> default_materials(std::uint32_t objects, std::uint32_t ground) {
  std::vector<Material> materials(objects);
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < objects; ++i) {
    if (i == ground) {
      materials[i] = {{0.66f, 0.65f, 0.63f}, 0.0f, 1};
    } else {
      materials[i] = {kWarm[next], 0.22f, 36};
      next = (next + 1) % kWarm.size();
    }
  }
  return materials;
}

}  // namespace gnomon::render
