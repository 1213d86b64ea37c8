// SPDX-License-Identifier: Apache-2.0
// Finds the owner of every cage edge, cage vertex and inner border of an n-gon.
#include "host/surface/borders.hpp"

#include <algorithm>
#include <map>

namespace gnomon::surface {
namespace {

/// Faces that share an edge or vertex agree up to rounding, or else not at all (some non-manifold cages).
constexpr double kAgreement = 1e-7;  // of the cage's diagonal

/// A cage face and one of its edges or vertices.
struct Feature {
  int face = 0;
  int index = 0;
};

double diagonal(const std::vector<Vec3>& points) {
  Box3 box;
  for (const Vec3& p : points) box.extendBy(p);
  return box.size().length();
}

}  // namespace

class BorderBuilder {
 public:
  BorderBuilder(const Cage& cage, const FaceSource& source, const std::vector<ParametricFace>& faces)
      : cage_(cage), source_(source), faces_(faces), tolerance_(kAgreement * diagonal(cage.positions)) {
    number_faces();
    find_owners();
  }

  Borders::FaceBorder border(std::uint32_t face) const {
    Borders::FaceBorder b;
    for (int side = 0; side < 4; ++side) {
      for (int half = 0; half < 2; ++half) b.sides[index(side)][index(half)] = piece(face, side, half);
    }
    for (int corner = 0; corner < 4; ++corner) {
      const Place p = corner_owner(face, corner);
      b.corners[index(corner)] = {p.face, static_cast<float>(p.u), 0, static_cast<float>(p.v), 0};
    }
    return b;
  }

  std::uint32_t torn() const { return torn_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  bool quad(int cage_face) const { return cage_.sizes[index(cage_face)] == 4; }
  int next(Feature f) const { return (f.index + 1) % cage_.sizes[index(f.face)]; }
  int previous(Feature f) const {
    const int n = cage_.sizes[index(f.face)];
    return (f.index + n - 1) % n;
  }
  std::uint32_t parametric(int cage_face, int sub_face) const {
    return first_[index(cage_face)] + static_cast<std::uint32_t>(sub_face);
  }

  void number_faces() {
    first_.assign(index(cage_.face_count()), 0);
    for (std::size_t i = faces_.size(); i-- > 0;)
      first_[index(faces_[i].cage_face)] = static_cast<std::uint32_t>(i);
    feature_base_.assign(cage_.offsets.begin(), cage_.offsets.end());
  }

  std::size_t slot(Feature f) const { return index(feature_base_[index(f.face)] + f.index); }

  // A point of an edge, `t` running as the face winds.
  Place on_edge(Feature e, double t) const {
    if (quad(e.face)) {
      const std::uint32_t f = parametric(e.face, 0);
      switch (e.index) {
        case 0:
          return {f, t, 0};
        case 1:
          return {f, 1, t};
        case 2:
          return {f, 1 - t, 1};
        default:
          return {f, 0, 1 - t};
      }
    }
    if (t <= 0.5) return {parametric(e.face, e.index), 2 * t, 0};
    return {parametric(e.face, next(e)), 0, 2 * (1 - t)};
  }

  Place on_vertex(Feature v) const {
    if (!quad(v.face)) return {parametric(v.face, v.index), 0, 0};
    return {parametric(v.face, 0), v.index == 1 || v.index == 2 ? 1.0 : 0.0, v.index >= 2 ? 1.0 : 0.0};
  }

  Vec3 raw(Place p) const { return source_.position(faces_[p.face], p.u, p.v); }
  bool agree(Place a, Place b) const { return (raw(a) - raw(b)).length() <= tolerance_; }

  bool reversed(Feature a, Feature b) const {
    return cage_.face(a.face)[index(a.index)] != cage_.face(b.face)[index(b.index)];
  }

  bool edges_agree(Feature a, Feature b) const {
    const bool flip = reversed(a, b);
    return std::ranges::all_of(std::array{0.25, 0.75},
                               [&](double t) { return agree(on_edge(a, t), on_edge(b, flip ? 1 - t : t)); });
  }

  // The first face in canonical order owns what it shares; a face that disagrees starts a group of its own.
  template <class Agree>
  Feature join(std::vector<Feature>& owners, Feature f, Agree agrees) {
    const auto found = std::ranges::find_if(owners, [&](Feature o) { return agrees(f, o); });
    if (found != owners.end()) return *found;
    if (!owners.empty()) ++torn_;
    owners.push_back(f);
    return f;
  }

  void find_owners() {
    std::map<std::pair<int, int>, std::vector<Feature>> edges;
    std::vector<std::vector<Feature>> vertices(cage_.positions.size());
    edge_owner_.resize(cage_.indices.size());
    vertex_owner_.resize(cage_.indices.size());
    for (int f = 0; f < cage_.face_count(); ++f) {
      if (!source_.valid(f)) continue;
      for (int k = 0; k < cage_.sizes[index(f)]; ++k) {
        const Feature feature{f, k};
        const int a = cage_.face(f)[index(k)];
        const int b = cage_.face(f)[index(next(feature))];
        edge_owner_[slot(feature)] = join(edges[std::minmax(a, b)], feature,
                                          [this](Feature x, Feature y) { return edges_agree(x, y); });
        vertex_owner_[slot(feature)] = join(vertices[index(a)], feature, [this](Feature x, Feature y) {
          return agree(on_vertex(x), on_vertex(y));
        });
      }
    }
  }

  Place owned_edge_point(Feature e, double t) const {
    const Feature owner = edge_owner_[slot(e)];
    return on_edge(owner, reversed(e, owner) ? 1 - t : t);
  }

  Place side_owner(std::uint32_t face, int side, double t) const {
    const auto [cage_face, sub] = faces_[face];
    if (sub < 0) return owned_edge_point({cage_face, side}, side < 2 ? t : 1 - t);
    const int before = previous({cage_face, sub});
    switch (side) {
      case 0:
        return owned_edge_point({cage_face, sub}, t / 2);
      case 1:
        return {face, 1, t};
      case 2:
        return {parametric(cage_face, before), 1, t};
      default:
        return owned_edge_point({cage_face, before}, 1 - t / 2);
    }
  }

  Place corner_owner(std::uint32_t face, int corner) const {
    const auto [cage_face, sub] = faces_[face];
    if (sub < 0) return on_vertex(vertex_owner_[slot({cage_face, corner})]);
    switch (corner) {
      case 0:
        return on_vertex(vertex_owner_[slot({cage_face, sub})]);
      case 1:
        return owned_edge_point({cage_face, sub}, 0.5);
      case 2:
        return {parametric(cage_face, 0), 1, 1};
      default:
        return owned_edge_point({cage_face, previous({cage_face, sub})}, 0.5);
    }
  }

  // Two samples of a half determine the map; every number here is a small dyadic, so nothing is rounded.
  Borders::Piece piece(std::uint32_t face, int side, int half) const {
    const double t = half == 0 ? 0.125 : 0.625;
    const Place a = side_owner(face, side, t);
    const Place b = side_owner(face, side, t + 0.25);
    const double du = (b.u - a.u) * 4;
    const double dv = (b.v - a.v) * 4;
    return {a.face, static_cast<float>(a.u - du * t), static_cast<float>(du),
            static_cast<float>(a.v - dv * t), static_cast<float>(dv)};
  }

  const Cage& cage_;
  const FaceSource& source_;
  const std::vector<ParametricFace>& faces_;
  double tolerance_;
  std::vector<std::uint32_t> first_;  // parametric face of each cage face
  std::vector<int> feature_base_;     // of each cage face in the two lists below
  std::vector<Feature> edge_owner_, vertex_owner_;
  std::uint32_t torn_ = 0;
};

Borders::Borders(const Cage& cage, const FaceSource& source, const std::vector<ParametricFace>& faces) {
  const BorderBuilder builder(cage, source, faces);
  torn_ = builder.torn();
  faces_.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) faces_.push_back(builder.border(f));
}

Place Borders::owner(std::uint32_t face, double u, double v) const {
  const FaceBorder& border = faces_[face];
  const bool on_u = u == 0 || u == 1;
  const bool on_v = v == 0 || v == 1;
  if (on_u && on_v) {
    const std::size_t corner = v == 0 ? (u == 0 ? 0 : 1) : (u == 0 ? 3 : 2);
    const Piece& p = border.corners[corner];
    return {p.face, p.u0, p.v0};
  }
  const std::size_t side = on_v ? (v == 0 ? 0 : 2) : (u == 0 ? 3 : 1);
  const double t = on_v ? u : v;
  const Piece& p = border.sides[side][t <= 0.5 ? 0 : 1];
  return {p.face, static_cast<double>(p.u0) + static_cast<double>(p.du) * t,
          static_cast<double>(p.v0) + static_cast<double>(p.dv) * t};
}

}  // namespace gnomon::surface
