// SPDX-License-Identifier: Apache-2.0
// Builds the cases.
#include "cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gnomon::outline::test {
namespace {

using scene::ControlMesh;

void add_face(ControlMesh& mesh, const std::vector<std::int32_t>& face) {
  mesh.face_sizes.push_back(static_cast<std::int32_t>(face.size()));
  mesh.face_indices.insert(mesh.face_indices.end(), face.begin(), face.end());
}

ControlMesh with_holes(ControlMesh mesh, std::vector<std::int32_t> holes) {
  mesh.holes = std::move(holes);
  return mesh;
}

/// Turns the winding of one face over.
ControlMesh with_reversed(ControlMesh mesh, std::size_t face) {
  std::size_t first = 0;
  for (std::size_t f = 0; f < face; ++f) first += static_cast<std::size_t>(mesh.face_sizes[f]);
  const auto begin = mesh.face_indices.begin() + static_cast<std::ptrdiff_t>(first);
  std::reverse(begin, begin + mesh.face_sizes[face]);
  return mesh;
}

ControlMesh creased(ControlMesh mesh, std::initializer_list<std::pair<std::size_t, float>> creases) {
  for (const auto& [face, sharpness] : creases) gnomon::test::crease_face(mesh, face, sharpness);
  return mesh;
}

/// Two boxes that have one edge in common: four faces meet there, and still it is a closed surface.
ControlMesh two_boxes() {
  ControlMesh m = box(10);
  const ControlMesh first = m;
  // The second is the first moved along (1,1,0): its vertices 0 and 4 are the first one's 3 and 7.
  const std::vector<std::int32_t> name{3, 8, 9, 10, 7, 11, 12, 13};
  for (const std::size_t v : {1U, 2U, 3U, 5U, 6U, 7U})
    m.positions.push_back(first.positions[v] + Vec3(1.4, 1.4, 0));
  for (std::size_t f = 0; f < 6; ++f) {
    std::vector<std::int32_t> face;
    face.reserve(4);
    for (std::size_t k = 0; k < 4; ++k)
      face.push_back(name[static_cast<std::size_t>(first.face_indices[4 * f + k])]);
    add_face(m, face);
    gnomon::test::crease_face(m, 6 + f, 10);
  }
  return m;
}

/// A box with a wall inside: three faces at two of the wall's edges.
ControlMesh walled_box() {
  ControlMesh m = box(0);
  add_face(m, {0, 3, 7, 4});
  return m;
}

}  // namespace

scene::ControlMesh box(float sharpness) {
  ControlMesh m;
  m.name = "box";
  for (int i = 0; i < 8; ++i)
    m.positions.push_back(Vec3((i & 1) * 1.4, ((i >> 1) & 1) * 1.4, (i >> 2) * 1.4) - Vec3(0.7));
  for (const auto& f : std::vector<std::vector<std::int32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    add_face(m, f);
  if (sharpness > 0)
    for (std::size_t f = 0; f < 6; ++f) gnomon::test::crease_face(m, f, sharpness);
  return m;
}

scene::ControlMesh cup() {
  ControlMesh m = box(0);
  m.name = "cup";
  m.face_sizes.erase(m.face_sizes.begin() + 1);
  m.face_indices.erase(m.face_indices.begin() + 4, m.face_indices.begin() + 8);
  return m;
}

scene::ControlMesh plate() {
  ControlMesh m;
  m.name = "plate";
  m.positions = {{-0.8, -0.7, 0}, {0.8, -0.7, 0}, {0.9, 0.6, 0}, {-0.8, 0.7, 0}, {0.1, 1.1, 0}};
  m.creases = {};
  add_face(m, {0, 1, 2, 3});
  add_face(m, {3, 2, 4});
  return m;
}

scene::ControlMesh moebius() {
  ControlMesh m;
  m.name = "moebius";
  constexpr int kQuads = 8;
  for (int i = 0; i < kQuads; ++i) {
    const double a = 2 * std::numbers::pi * i / kQuads;
    for (const double s : {-0.35, 0.35}) {
      const double r = 0.75 + s * std::cos(a / 2);
      m.positions.push_back({r * std::cos(a), r * std::sin(a), s * std::sin(a / 2)});
    }
  }
  for (std::int32_t i = 0; i < kQuads; ++i) {
    const bool last = i + 1 == kQuads;
    const std::int32_t next = last ? 0 : 2 * i + 2;
    add_face(m, {2 * i, next + (last ? 1 : 0), next + (last ? 0 : 1), 2 * i + 1});
  }
  return m;
}

std::vector<Case> all_cases() {
  using namespace gnomon::test;
  return {
      {"sphere", false, spindle(3)},
      {"two poles of valence 5", false, spindle(5)},
      {"valence 2", false, spindle(2)},
      {"torus", false, torus(8, 6)},
      {"thin torus", false, torus(12, 5, 0.15)},
      {"smooth box", false, box(0)},
      {"half-sharp box", false, box(1.5F)},
      {"box", false, box(10)},
      {"creased spindle", false, creased(spindle(4), {{0, 10.0F}, {3, 2.0F}})},
      {"prism of n-gons", false, prism(5)},
      {"pyramid", false, pyramid(3)},
      {"cup", true, cup()},
      {"wavy sheet", true, sheet(3, 4)},
      {"plate", true, plate()},
      {"torus with holes", true, with_holes(torus(8, 6), {0, 1, 6, 20})},
      {"moebius band", true, moebius()},
      {"one face reversed", true, with_reversed(torus(6, 4), 5)},
      {"book of three", true, book(3)},
      {"book of four", true, book(4)},
      {"bow tie", false, bow_tie()},
      {"two boxes at an edge", false, two_boxes()},
      {"walled box", true, walled_box()},
  };
}

std::vector<Light> all_lights() {
  return {{"oblique", {0.31, -0.83, -0.46}},
          {"grazing", {0.93, 0.11, -0.21}},
          {"along x", {1, 0, 0}},
          {"along -z", {0, 0, -1}},
          {"along xy", {1, 1, 0}},
          {"along xyz", {-1, -1, -1}},
          {"almost along z", {1e-7, 3e-8, 1}},
          {"a hair off z", {5e-10, 1.4e-9, 1}}};
}

LightFrame view_along(const Vec3& light, const Box3& box, double pixels, bool mirrored) {
  const Vec3 d = light.normalized();
  const Vec3 axis = std::abs(d.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  const Vec3 right = d.cross(axis).normalized();
  const double scale = pixels / box.size().length();
  LightFrame f{right * (mirrored ? -scale : scale), right.cross(d) * scale, d * (100 * scale)};
  f.x1 = pixels / 2 - f.x.dot(box.center());
  f.y1 = pixels / 2 - f.y.dot(box.center());
  f.depth1 = 50 * pixels - f.depth.dot(box.center());
  return f;
}

surface::LimitSurface limit_of(const scene::ControlMesh& mesh, double scale) {
  Mat4 grid;
  grid.setScale(Vec3(scale));
  auto surface = surface::LimitSurface::build(mesh, grid);
  if (!surface) throw std::runtime_error(surface.error().message);
  return std::move(*surface);
}

Box3 box_of(const scene::ControlMesh& mesh) {
  Box3 box;
  for (const Vec3& p : mesh.positions) box.extendBy(p);
  return box;
}

ObjectOutline outline_of(const surface::LimitSurface& surface, const LightFrame& frame,
                         const Options& options) {
  auto result = outlines({&surface, 1}, frame, options);
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(result->at(0));
}

}  // namespace gnomon::outline::test
