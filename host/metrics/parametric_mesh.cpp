// SPDX-License-Identifier: Apache-2.0
// Stitching: collect every vertex on every line of a face, share the borders' vertices between faces, then
// cut polygons.
#include "host/metrics/parametric_mesh.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>

#include "host/metrics/face_borders.hpp"

namespace gnomon::metrics {
namespace {

using Param = std::array<float, 2>;

/// Two parameters in one number that sorts as they do, the first before the second: the bits of floats that
/// are not negative are in order.
using Key = std::uint64_t;

Key key(float first, float second) {
  return (Key{std::bit_cast<std::uint32_t>(first)} << 32) | std::bit_cast<std::uint32_t>(second);
}
float first_of(Key key) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32));
}
float second_of(Key key) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(key));
}

/// The vertices of one face, as (v, u) and as (u, v), both sorted: every line of the face is a run in one of
/// them.
struct FaceVertices {
  std::vector<Key> vu, uv;

  void add(float u, float v) { vu.push_back(key(v, u)); }
  /// Most vertices are added once for each of the rectangles around them: uv is made of what is left of vu.
  void sort() {
    std::sort(vu.begin(), vu.end());
    vu.erase(std::unique(vu.begin(), vu.end()), vu.end());
    uv.resize(vu.size());
    std::transform(vu.begin(), vu.end(), uv.begin(), [](Key p) { return key(second_of(p), first_of(p)); });
    std::sort(uv.begin(), uv.end());
  }
  std::uint32_t index(float u, float v) const {
    const auto found = std::lower_bound(vu.begin(), vu.end(), key(v, u));
    assert(found != vu.end() && *found == key(v, u));
    return static_cast<std::uint32_t>(found - vu.begin());
  }
  /// Positions along a line strictly between two of its points.
  static std::span<const Key> between(const std::vector<Key>& list, float line, float from, float to) {
    const auto first = std::upper_bound(list.begin(), list.end(), key(line, from));
    const auto last = std::lower_bound(first, list.end(), key(line, to));
    return {first, last};
  }
  std::span<const Key> along(Side side, float from, float to) const {
    const bool u_runs = side == Side::LowV || side == Side::HighV;
    const float line = side == Side::HighU || side == Side::HighV ? 1.0f : 0.0f;
    return between(u_runs ? vu : uv, line, from, to);
  }
};

struct FaceRects {
  std::uint32_t face;
  std::span<const std::uint32_t> rects;  ///< indices into all rectangles
  FaceVertices vertices;
};

struct FaceMesh {
  std::vector<std::array<float, 3>> points, normals;
  std::vector<Param> params;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> rect_of_triangle;
};

std::vector<FaceRects> group_by_face(std::span<const ParamRect> rects,
                                     std::span<const std::uint32_t> sorted) {
  std::vector<FaceRects> faces;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    const std::uint32_t face = rects[sorted[begin]].face;
    while (end < sorted.size() && rects[sorted[end]].face == face) ++end;
    faces.push_back({face, sorted.subspan(begin, end - begin), {}});
  }
  return faces;
}

void collect_corners(std::span<const ParamRect> rects, FaceRects& face) {
  for (const std::uint32_t i : face.rects) {
    const ParamRect& r = rects[i];
    face.vertices.add(r.u0, r.v0);
    face.vertices.add(r.u1, r.v0);
    face.vertices.add(r.u1, r.v1);
    face.vertices.add(r.u0, r.v1);
  }
  face.vertices.sort();
}

/// What one face's side gains from its neighbours.
struct Addition {
  std::size_t face;
  float u, v;
};

void share_group(BorderGroup group, std::span<const FaceRects> faces, std::span<const std::size_t> place,
                 std::vector<Addition>& additions) {
  std::vector<double> common;
  const bool lengths_differ = std::any_of(group.begin(), group.end(), [&](const BorderPiece& piece) {
    return piece.whole() != group.front().whole();
  });
  // The end of a side is a vertex even where it lies halfway along the neighbour's side.
  if (lengths_differ) common = {0, 1};
  for (const BorderPiece& piece : group)
    for (const Key p : faces[place[piece.face]].vertices.along(piece.side, piece.t0, piece.t1))
      common.push_back(piece.common(double{second_of(p)}));
  std::sort(common.begin(), common.end());
  common.erase(std::unique(common.begin(), common.end()), common.end());
  for (const BorderPiece& piece : group)
    for (const double s : common) {
      const auto [u, v] = on_side(piece.side, piece.at(s));
      additions.push_back({place[piece.face], static_cast<float>(u), static_cast<float>(v)});
    }
}

void share_borders(const surface::LimitSurface& surface, std::vector<FaceRects>& faces) {
  std::vector<std::uint32_t> ids;
  std::vector<std::size_t> place(surface.face_count());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    ids.push_back(faces[i].face);
    place[faces[i].face] = i;
  }
  const FaceBorders borders(surface, ids);
  std::vector<Addition> additions;
  for (std::size_t g = 0; g < borders.size(); ++g) share_group(borders[g], faces, place, additions);
  for (const Addition& a : additions) faces[a.face].vertices.add(a.u, a.v);
}

/// The rectangle's outline with every vertex on it, anticlockwise in (u, v). Vertices of a line of equal v
/// follow one another in vu, so that one search finds them all.
void outline(const FaceVertices& vertices, const ParamRect& r, std::vector<std::uint32_t>& out) {
  out.clear();
  std::uint32_t at = vertices.index(r.u0, r.v0);
  for (; second_of(vertices.vu[at]) < r.u1; ++at) out.push_back(at);
  out.push_back(at);
  for (const Key p : FaceVertices::between(vertices.uv, r.u1, r.v0, r.v1))
    out.push_back(vertices.index(r.u1, second_of(p)));
  at = vertices.index(r.u1, r.v1);
  for (; second_of(vertices.vu[at]) > r.u0; --at) out.push_back(at);
  out.push_back(at);
  const auto left = FaceVertices::between(vertices.uv, r.u0, r.v0, r.v1);
  for (auto p = left.rbegin(); p != left.rend(); ++p) out.push_back(vertices.index(r.u0, second_of(*p)));
}

class FaceBuilder {
 public:
  FaceBuilder(const surface::LimitSurface& surface, const Vec3& center, bool normals)
      : surface_(surface), center_(center), normals_(normals) {}

  FaceMesh build(std::span<const ParamRect> rects, const FaceRects& face) const {
    FaceMesh mesh;
    for (const Key vu : face.vertices.vu) add_point(mesh, face.face, second_of(vu), first_of(vu));
    std::vector<std::uint32_t> polygon;
    for (const std::uint32_t i : face.rects) {
      outline(face.vertices, rects[i], polygon);
      if (polygon.size() == 4)
        add_quad(mesh, polygon, i);
      else
        add_fan(mesh, polygon, rects[i], i);
    }
    return mesh;
  }

 private:
  void add_point(FaceMesh& mesh, std::uint32_t face, float u, float v) const {
    const Vec3 p = surface_.position(face, u, v) - center_;
    mesh.points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    mesh.params.push_back({u, v});
    if (!normals_) return;
    const Vec3 n = surface_.normal(face, u, v);
    mesh.normals.push_back({static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)});
  }
  static void add_triangle(FaceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                           std::uint32_t rect) {
    mesh.triangles.push_back({a, b, c});
    mesh.rect_of_triangle.push_back(rect);
  }
  static void add_quad(FaceMesh& mesh, std::span<const std::uint32_t> p, std::uint32_t rect) {
    add_triangle(mesh, p[0], p[1], p[2], rect);
    add_triangle(mesh, p[0], p[2], p[3], rect);
  }
  /// Around the middle, so that vertices in line with a corner make no triangle without area.
  void add_fan(FaceMesh& mesh, std::span<const std::uint32_t> p, const ParamRect& r,
               std::uint32_t rect) const {
    const auto middle = static_cast<std::uint32_t>(mesh.points.size());
    add_point(mesh, r.face, 0.5f * (r.u0 + r.u1), 0.5f * (r.v0 + r.v1));
    for (std::size_t i = 0; i < p.size(); ++i) add_triangle(mesh, middle, p[i], p[(i + 1) % p.size()], rect);
  }

  const surface::LimitSurface& surface_;
  Vec3 center_;
  bool normals_;
};

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

ParametricMesh join(std::vector<FaceMesh>& parts, const Vec3& center) {
  ParametricMesh mesh;
  mesh.center = center;
  for (FaceMesh& part : parts) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (auto& triangle : part.triangles)
      for (auto& corner : triangle) corner += first;
    append(mesh.points, part.points);
    append(mesh.normals, part.normals);
    append(mesh.params, part.params);
    append(mesh.triangles, part.triangles);
    append(mesh.rect_of_triangle, part.rect_of_triangle);
    part = {};
  }
  return mesh;
}

}  // namespace

ParametricMesh triangulate(const surface::LimitSurface& surface, std::span<const ParamRect> rects,
                           const Vec3& center, bool normals) {
  std::vector<std::uint32_t> sorted(rects.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return rects[a].face < rects[b].face; });
  std::vector<FaceRects> faces = group_by_face(rects, sorted);
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) { collect_corners(rects, faces[i]); });
  share_borders(surface, faces);
  std::vector<FaceMesh> parts(faces.size());
  const FaceBuilder builder(surface, center, normals);
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    faces[i].vertices.sort();
    parts[i] = builder.build(rects, faces[i]);
    faces[i].vertices = {};
  });
  return join(parts, center);
}

}  // namespace gnomon::metrics
