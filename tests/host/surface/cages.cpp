// SPDX-License-Identifier: Apache-2.0
// Builds the cages.
#include "cages.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace gnomon::test {
namespace {

using Face = std::vector<std::int32_t>;

void add_face(scene::ControlMesh& mesh, const Face& face) {
  mesh.face_sizes.push_back(static_cast<std::int32_t>(face.size()));
  mesh.face_indices.insert(mesh.face_indices.end(), face.begin(), face.end());
}

std::vector<Face> faces_of(const scene::ControlMesh& mesh) {
  std::vector<Face> faces;
  auto it = mesh.face_indices.begin();
  for (const auto n : mesh.face_sizes) {
    faces.emplace_back(it, it + n);
    it += n;
  }
  return faces;
}

Vec3 on_circle(int i, int n, double radius, double z) {
  const double a = 2 * std::numbers::pi * i / n;
  return {radius * std::cos(a), radius * std::sin(a), z};
}

}  // namespace

scene::ControlMesh spindle(int n, double radius) {
  scene::ControlMesh m;
  m.name = "spindle";
  m.positions = {{0, 0, 1}, {0, 0, -1}};
  for (int i = 0; i < 2 * n; ++i) m.positions.push_back(on_circle(i, 2 * n, radius, i % 2 == 0 ? 0.3 : -0.3));
  const auto ring = [&](int i) { return 2 + i % (2 * n); };
  for (int i = 0; i < 2 * n; i += 2) {
    add_face(m, {0, ring(i), ring(i + 1), ring(i + 2)});
    add_face(m, {1, ring(i + 3), ring(i + 2), ring(i + 1)});
  }
  return m;
}

scene::ControlMesh prism(int n) {
  scene::ControlMesh m;
  m.name = "prism";
  Face top;
  Face bottom;
  for (int i = 0; i < n; ++i) {
    m.positions.push_back(on_circle(i, n, 1, -0.7));
    m.positions.push_back(on_circle(i, n, 1, 0.7));
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
    const int j = (i + 1) % n;
    add_face(m, {2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
  }
  add_face(m, top);
  add_face(m, bottom);
  return m;
}

scene::ControlMesh pyramid(int n) {
  scene::ControlMesh m;
  m.name = "pyramid";
  m.positions.push_back({0, 0, 1});
  Face base;
  for (int i = 0; i < n; ++i) {
    m.positions.push_back(on_circle(i, n, 1, -0.5));
    base.insert(base.begin(), i + 1);
    add_face(m, {0, i + 1, (i + 1) % n + 1});
  }
  add_face(m, base);
  return m;
}

scene::ControlMesh torus(int m, int n, double thickness) {
  scene::ControlMesh out;
  out.name = "torus";
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) {
      const double b = 2 * std::numbers::pi * j / n;
      out.positions.push_back(on_circle(i, m, 1 + thickness * std::cos(b), thickness * std::sin(b)));
    }
  }
  const auto at = [&](int i, int j) { return (i % m) * n + j % n; };
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < n; ++j) add_face(out, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  return out;
}

scene::ControlMesh sheet(int nx, int ny, double length) {
  scene::ControlMesh m;
  m.name = "sheet";
  for (int y = 0; y <= ny; ++y) {
    for (int x = 0; x <= nx; ++x) {
      m.positions.push_back({length * x / nx, 1.0 * y / ny, 0.15 * std::sin(1.7 * x) * std::cos(1.3 * y)});
    }
  }
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      const int a = y * (nx + 1) + x;
      add_face(m, {a, a + 1, a + nx + 2, a + nx + 1});
    }
  }
  return m;
}

scene::ControlMesh needle_box(int n, double length) {
  scene::ControlMesh m;
  m.name = "needles";
  Face left;
  Face right;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = on_circle(i, n, 1, 0);
    m.positions.push_back({0, p.x, p.y});
    m.positions.push_back({length, p.x, p.y});
    left.insert(left.begin(), 2 * i);
    right.push_back(2 * i + 1);
    const int j = (i + 1) % n;
    add_face(m, {2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
  }
  add_face(m, left);
  add_face(m, right);
  return m;
}

scene::ControlMesh book(int n) {
  scene::ControlMesh m;
  m.name = "book";
  m.positions = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i < n; ++i) {
    m.positions.push_back(on_circle(i, n, 1, 0));
    m.positions.push_back(on_circle(i, n, 1, 1));
    add_face(m, {0, 2 * i + 2, 2 * i + 3, 1});
  }
  return m;
}

scene::ControlMesh bow_tie() {
  scene::ControlMesh m = spindle(3);
  scene::ControlMesh other = spindle(4);
  const auto shift = static_cast<std::int32_t>(m.positions.size()) - 1;
  // The second one's lower pole is the first one's upper.
  for (std::size_t i = 0; i < other.positions.size(); ++i) {
    if (i != 1) m.positions.push_back(other.positions[i] + Vec3(0, 0, 2));
  }
  for (const Face& f : faces_of(other)) {
    Face g;
    for (const auto v : f) g.push_back(v == 1 ? 0 : (v == 0 ? shift + 1 : shift + v));
    add_face(m, g);
  }
  return m;
}

void crease_face(scene::ControlMesh& mesh, std::size_t face, float sharpness) {
  const Face f = faces_of(mesh)[face];
  for (std::size_t i = 0; i < f.size(); ++i) mesh.creases.push_back({f[i], f[(i + 1) % f.size()], sharpness});
}

scene::ControlMesh shuffled(const scene::ControlMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Face> faces = faces_of(mesh);
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  scene::ControlMesh out = mesh;
  out.face_sizes.clear();
  out.face_indices.clear();
  out.holes.clear();
  for (const std::size_t f : order) {
    std::rotate(faces[f].begin(), faces[f].begin() + static_cast<std::ptrdiff_t>(random() % faces[f].size()),
                faces[f].end());
    add_face(out, faces[f]);
    if (std::ranges::count(mesh.holes, static_cast<std::int32_t>(f)) > 0) {
      out.holes.push_back(static_cast<std::int32_t>(out.face_sizes.size() - 1));
    }
  }
  std::shuffle(out.creases.begin(), out.creases.end(), random);
  return out;
}

Mat4 fit_to_grid(const std::vector<scene::ControlMesh>& meshes, double res, double margin) {
  Box3 box;
  for (const auto& m : meshes) {
    for (const Vec3& p : m.positions) box.extendBy(p);
  }
  const Vec3 size = box.size();
  const double scale = (res - 2 * margin) / std::max({size.x, size.y, size.z});
  Mat4 s;
  s.setScale(Vec3(scale));
  Mat4 t;
  t.setTranslation(Vec3(res / 2) - box.center() * scale);
  return s * t;
}

}  // namespace gnomon::test
