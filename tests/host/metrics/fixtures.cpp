// SPDX-License-Identifier: Apache-2.0
// Cages made by formula.
#include "tests/host/metrics/fixtures.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/voxel/voxelizer.hpp"

namespace gnomon::fixtures {
namespace {

void add_face(scene::ControlMesh& mesh, std::initializer_list<int> face) {
  mesh.face_sizes.push_back(static_cast<std::int32_t>(face.size()));
  for (const int v : face) mesh.face_indices.push_back(v);
}

}  // namespace

scene::ControlMesh rectangle(double x0, double y0, double x1, double y1, double z) {
  return sheet(x0, y0, x1, y1, z, 1, 1);
}

scene::ControlMesh sheet(double x0, double y0, double x1, double y1, double z, int nx, int ny) {
  scene::ControlMesh mesh;
  mesh.name = "sheet";
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i)
      mesh.positions.emplace_back(x0 + (x1 - x0) * i / nx, y0 + (y1 - y0) * j / ny, z);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int first = j * (nx + 1) + i;
      add_face(mesh, {first, first + 1, first + nx + 2, first + nx + 1});
    }
  return mesh;
}

scene::ControlMesh box(const Vec3& low, const Vec3& high, bool sharp) {
  scene::ControlMesh mesh;
  mesh.name = "box";
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                (corner & 4) != 0 ? high.z : low.z);
  add_face(mesh, {0, 2, 3, 1});
  add_face(mesh, {4, 5, 7, 6});
  add_face(mesh, {0, 1, 5, 4});
  add_face(mesh, {2, 6, 7, 3});
  add_face(mesh, {0, 4, 6, 2});
  add_face(mesh, {1, 3, 7, 5});
  if (!sharp) return mesh;
  constexpr std::array<std::array<int, 2>, 12> kEdges = {
      {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  for (const auto& [a, b] : kEdges) mesh.creases.push_back({a, b, 10});
  return mesh;
}

scene::ControlMesh torus(const Vec3& center, double major, double minor, int around, int across) {
  // On a regular cage the limit at a vertex is a product of cubic B-splines, which scale cos(k angle) by (4 +
  // 2 cos) / 6.
  const double step_a = 2 * std::numbers::pi / around;
  const double step_b = 2 * std::numbers::pi / across;
  const double shrink_a = (4 + 2 * std::cos(step_a)) / 6;
  const double shrink_b = (4 + 2 * std::cos(step_b)) / 6;
  scene::ControlMesh mesh;
  mesh.name = "torus";
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double r = (major + minor / shrink_b * std::cos(j * step_b)) / shrink_a;
      mesh.positions.push_back(center + Vec3(r * std::cos(i * step_a), r * std::sin(i * step_a),
                                             minor / shrink_b * std::sin(j * step_b)));
    }
  const auto vertex = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      add_face(mesh, {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  return mesh;
}

scene::ControlMesh prism(int n, const Vec3& center, double radius, double height, bool sharp) {
  scene::ControlMesh mesh;
  mesh.name = "prism";
  for (int level = 0; level < 2; ++level)
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      mesh.positions.push_back(
          center + Vec3(radius * std::cos(angle), radius * std::sin(angle), (level - 0.5) * height));
    }
  mesh.face_sizes = {n, n};
  for (int i = 0; i < n; ++i) mesh.face_indices.push_back(n - 1 - i);
  for (int i = 0; i < n; ++i) mesh.face_indices.push_back(n + i);
  for (int i = 0; i < n; ++i) add_face(mesh, {i, (i + 1) % n, n + (i + 1) % n, n + i});
  if (!sharp) return mesh;
  for (int i = 0; i < n; ++i) {
    mesh.creases.push_back({i, (i + 1) % n, 10});
    mesh.creases.push_back({n + i, n + (i + 1) % n, 10});
    mesh.creases.push_back({i, n + i, 10});
  }
  return mesh;
}

std::vector<surface::LimitSurface> surfaces(const std::vector<scene::ControlMesh>& meshes) {
  std::vector<surface::LimitSurface> result;
  for (const scene::ControlMesh& mesh : meshes) {
    auto surface = surface::LimitSurface::build(mesh, Mat4());
    if (!surface) throw std::runtime_error(surface.error().message);
    result.push_back(std::move(*surface));
  }
  return result;
}

voxel::VoxelSet voxels(const std::vector<surface::LimitSurface>& surfaces, std::uint32_t res) {
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  auto set = voxel::voxelize(surfaces, {res, Vec3(0, 0, 0), 1.0, voxel::Adjacency::N26}, options);
  if (!set) throw std::runtime_error(set.error().message);
  return std::move(*set);
}

}  // namespace gnomon::fixtures
