// SPDX-License-Identifier: Apache-2.0
// Where things are and how large.
#include "host/scene/placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gnomon::scene {
namespace {

/// The axes of the ground's rectangle for an up axis.
struct Axes {
  int up, first, second;  ///< first x second = +up
};

Axes axes(UpAxis up) {
  return up == UpAxis::Y ? Axes{1, 2, 0} : Axes{2, 0, 1};
}

double largest_side(const Box3& box) {
  return std::max({box.size().x, box.size().y, box.size().z});
}

std::array<Vec3, 8> corners(const Box3& box) {
  std::array<Vec3, 8> all;
  for (unsigned i = 0; i < all.size(); ++i) {
    all[i] = {(i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
              (i & 4U) != 0 ? box.max.z : box.min.z};
  }
  return all;
}

/// How far the shadow of a point at `height` above the floor falls from the point below it, horizontally and
/// at most `longest`; zero where no shadow falls on the floor.
Vec3 shadow_reach(const Light& light, const Vec3& point, double height, double longest, int up) {
  Vec3 way = light_way(light, point);
  const double down = -way[up];
  if (!(down > 0) && std::holds_alternative<DirectionalLight>(light)) return {0, 0, 0};
  way[up] = 0;
  // What a lamp below the point throws upwards at it, it throws beyond all bounds from a little lower.
  if (!(down > 0) || way.length() * height > longest * down) return way.normalized() * longest;
  return way * (height / down);
}

/// True where no part of the models can throw a shadow on the floor.
bool below_floor(const Light& light, int up, double floor) {
  if (const auto* spot = std::get_if<SpotLight>(&light)) return spot->position[up] <= floor;
  if (const auto* point = std::get_if<PointLight>(&light)) return point->position[up] <= floor;
  return false;
}

/// Footprint of the models and of their shadows on the plane through their lowest point; its height is that
/// plane's.
Box3 shadow_footprint(std::span<const Box3> models, const Axes& a, std::span<const Light> lights) {
  Box3 all;
  for (const Box3& model : models) all.extendBy(model);
  const double floor = all.min[a.up];
  const double longest = largest_side(all);
  Box3 footprint = all;
  for (const Light& light : lights) {
    if (below_floor(light, a.up, floor)) continue;
    // A lamp near by throws a corner of the box around all models much farther than any of them reaches.
    const bool directional = std::holds_alternative<DirectionalLight>(light);
    for (const Box3& box : directional ? std::span<const Box3>(&all, 1) : models) {
      for (const Vec3& corner : corners(box))
        footprint.extendBy(corner + shadow_reach(light, corner, corner[a.up] - floor, longest, a.up));
    }
  }
  footprint.min[a.up] = footprint.max[a.up] = floor;
  const double border = 0.15 * longest;
  for (const int axis : {a.first, a.second}) {
    footprint.min[axis] -= border;
    footprint.max[axis] += border;
  }
  return footprint;
}

}  // namespace

Vec3 up_direction(UpAxis up) {
  return up == UpAxis::Y ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
}

DirectionalLight default_light(UpAxis up) {
  return {(up == UpAxis::Y ? Vec3(0.45, -1, -0.4) : Vec3(0.45, 0.4, -1)).normalized()};
}

Object make_ground(std::span<const Box3> models, UpAxis up, std::span<const Light> lights) {
  constexpr std::int32_t kCells = 4;
  const Axes a = axes(up);
  const Box3 area = shadow_footprint(models, a, lights);
  Object ground;
  ground.name = "ground";
  ground.ground = true;
  ground.two_sided = true;
  ground.mesh.name = "ground";
  ground.mesh.boundary = Boundary::EdgeAndCorner;
  for (std::int32_t j = 0; j <= kCells; ++j) {
    for (std::int32_t i = 0; i <= kCells; ++i) {
      Vec3 p = area.min;
      p[a.first] += (area.max[a.first] - area.min[a.first]) * i / kCells;
      p[a.second] += (area.max[a.second] - area.min[a.second]) * j / kCells;
      ground.mesh.positions.push_back(p);
    }
  }
  const auto vertex = [](std::int32_t i, std::int32_t j) { return j * (kCells + 1) + i; };
  for (std::int32_t j = 0; j < kCells; ++j) {
    for (std::int32_t i = 0; i < kCells; ++i) {
      ground.mesh.face_sizes.push_back(4);
      for (const std::int32_t v : {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}) {
        ground.mesh.face_indices.push_back(v);
      }
    }
  }
  ground.bounds = area;
  ground.statistics = measure(ground.mesh);
  return ground;
}

Camera fit_camera(const Box3& models, const Box3& all, UpAxis up, double image_aspect) {
  Camera camera;
  camera.up = up_direction(up);
  const Vec3 side(1, 0, 0);
  const Vec3 front = up == UpAxis::Y ? Vec3(0, 0, 1) : Vec3(0, -1, 0);
  const Vec3 towards_eye = (front + side * 0.55 + camera.up * 0.6).normalized();
  const Vec3 right = camera.up.cross(towards_eye).normalized();
  const Vec3 above = towards_eye.cross(right);

  // The models, and all of the ground: a cut corner looks like a mistake.
  const double floor = std::min(all.min.dot(camera.up), all.max.dot(camera.up));
  std::vector<Vec3> points;
  for (const Vec3& corner : corners(models)) points.push_back(corner);
  for (const Vec3& corner : corners(all))
    points.push_back(corner - camera.up * (corner.dot(camera.up) - floor));
  Box3 seen;  // along right, above, and towards the eye
  for (const Vec3& p : points) seen.extendBy(Vec3(p.dot(right), p.dot(above), p.dot(towards_eye)));
  const Vec3 middle = seen.center();
  camera.target = right * middle.x + above * middle.y + towards_eye * middle.z;

  // For each point, the distance at which it just touches the frame.
  const double tan_vertical = std::tan(camera.fov * std::numbers::pi / 360);
  const double tan_horizontal = tan_vertical * image_aspect;
  double distance = 0;
  for (const Vec3& point : points) {
    const Vec3 p = point - camera.target;
    const double depth = p.dot(towards_eye);
    distance = std::max({distance, depth + std::abs(p.dot(right)) / tan_horizontal,
                         depth + std::abs(p.dot(above)) / tan_vertical});
  }
  camera.eye = camera.target + towards_eye * (1.03 * distance);
  return camera;
}

}  // namespace gnomon::scene
