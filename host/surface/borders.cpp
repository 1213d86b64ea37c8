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

// Numbers the curves and vertices, finds their owners, and fills the tables of one Borders.
class BorderBuilder {
 public:
  BorderBuilder(Borders& out, const Cage& cage, const FaceSource& source,
                const std::vector<ParametricFace>& faces)
      : out_(out),
        cage_(cage),
        source_(source),
        faces_(faces),
        tolerance_(kAgreement * diagonal(cage.positions)) {
    first_.assign(index(cage.face_count()), 0);
    for (std::size_t i = faces.size(); i-- > 0;)
      first_[index(faces[i].cage_face)] = static_cast<std::uint32_t>(i);
    own_edges_and_vertices();
    own_inner_borders();
    for (std::uint32_t f = 0; f < faces.size(); ++f) out_.faces_.push_back(border(f));
  }

 private:
  // An edge of a cage face as a stretch of a curve.
  struct Edge {
    std::uint32_t curve;
    bool reversed;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::size_t slot(Feature f) const { return index(cage_.offsets[index(f.face)] + f.index); }
  int size(int cage_face) const { return cage_.sizes[index(cage_face)]; }
  bool quad(int cage_face) const { return size(cage_face) == 4; }
  int next(Feature f) const { return (f.index + 1) % size(f.face); }
  int previous(Feature f) const { return (f.index + size(f.face) - 1) % size(f.face); }
  int vertex(Feature f) const { return cage_.face(f.face)[index(f.index)]; }
  std::uint32_t parametric(int cage_face, int sub_face) const {
    return first_[index(cage_face)] + static_cast<std::uint32_t>(sub_face);
  }

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

  // Whether two edges between the same vertices wind against each other.
  bool reversed(Feature a, Feature b) const { return vertex(a) != vertex(b); }

  bool edges_agree(Feature a, Feature b) const {
    const bool flip = reversed(a, b);
    return std::ranges::all_of(std::array{0.25, 0.75},
                               [&](double t) { return agree(on_edge(a, t), on_edge(b, flip ? 1 - t : t)); });
  }

  struct Owner {
    Feature feature;
    std::uint32_t id;
  };

  // The first face in canonical order owns what it shares; a face that disagrees starts a group of its own.
  template <class Agree, class Create>
  Owner join(std::vector<Owner>& owners, Feature f, Agree agrees, Create create) {
    const auto found = std::ranges::find_if(owners, [&](const Owner& o) { return agrees(f, o.feature); });
    if (found != owners.end()) return *found;
    if (!owners.empty()) ++out_.torn_;
    owners.push_back({f, create(f)});
    return owners.back();
  }

  std::uint32_t add_vertex(Place p) {
    out_.vertices_.push_back(p);
    return static_cast<std::uint32_t>(out_.vertices_.size() - 1);
  }

  // Two samples of a half determine its map; every number here is a small dyadic, so nothing is rounded.
  template <class At>
  std::uint32_t add_curve(At at) {
    Borders::Curve curve{};
    for (const int half : {0, 1}) {
      const double t = half == 0 ? 0.125 : 0.625;
      const Place a = at(t);
      const Place b = at(t + 0.25);
      const double du = (b.u - a.u) * 4;
      const double dv = (b.v - a.v) * 4;
      curve[index(half)] = {a.face, static_cast<float>(a.u - du * t), static_cast<float>(du),
                            static_cast<float>(a.v - dv * t), static_cast<float>(dv)};
    }
    out_.curves_.push_back(curve);
    return static_cast<std::uint32_t>(out_.curves_.size() - 1);
  }

  void own_edges_and_vertices() {
    std::map<std::pair<int, int>, std::vector<Owner>> edges;
    std::vector<std::vector<Owner>> vertices(cage_.positions.size());
    edges_.resize(cage_.indices.size());
    vertices_.resize(cage_.indices.size());
    for (int f = 0; f < cage_.face_count(); ++f) {
      if (!source_.valid(f)) continue;
      for (int k = 0; k < size(f); ++k) {
        const Feature here{f, k};
        const int a = vertex(here);
        const int b = vertex({f, next(here)});
        const Owner edge = join(
            edges[std::minmax(a, b)], here, [this](Feature x, Feature y) { return edges_agree(x, y); },
            [this](Feature x) { return add_curve([&](double t) { return on_edge(x, t); }); });
        edges_[slot(here)] = {edge.id, reversed(here, edge.feature)};
        vertices_[slot(here)] =
            join(
                vertices[index(a)], here,
                [this](Feature x, Feature y) { return agree(on_vertex(x), on_vertex(y)); },
                [this](Feature x) { return add_vertex(on_vertex(x)); })
                .id;
      }
    }
  }

  // An n-gon's centre, and the borders from the middles of its edges to it.
  void own_inner_borders() {
    spokes_.resize(cage_.indices.size());
    centres_.resize(index(cage_.face_count()));
    for (int f = 0; f < cage_.face_count(); ++f) {
      if (!source_.valid(f) || quad(f)) continue;
      centres_[index(f)] = add_vertex({parametric(f, 0), 1, 1});
      for (int k = 0; k < size(f); ++k) {
        spokes_[slot({f, k})] = add_curve([&](double t) { return Place{parametric(f, k), 1, t}; });
      }
    }
  }

  Borders::Side edge_side(Feature e, float a, float b) const {
    const Edge edge = edges_[slot(e)];
    return edge.reversed ? Borders::Side{edge.curve, 1 - a, -b} : Borders::Side{edge.curve, a, b};
  }

  Borders::FaceBorder border(std::uint32_t face) const {
    const auto [f, sub] = faces_[face];
    if (sub < 0) {
      Borders::FaceBorder b{};
      for (int k = 0; k < 4; ++k) {
        b.sides[index(k)] = edge_side({f, k}, k < 2 ? 0 : 1, k < 2 ? 1 : -1);
        b.corners[index(k)] = {true, vertices_[slot({f, k})], 0};
      }
      return b;
    }
    const Feature leaving{f, sub};
    const Feature arriving{f, previous(leaving)};
    return {{edge_side(leaving, 0, 0.5F), Borders::Side{spokes_[slot(leaving)], 0, 1},
             Borders::Side{spokes_[slot(arriving)], 0, 1}, edge_side(arriving, 1, -0.5F)},
            {Borders::Corner{true, vertices_[slot(leaving)], 0},
             Borders::Corner{false, edges_[slot(leaving)].curve, 0.5F},
             Borders::Corner{true, centres_[index(f)], 0},
             Borders::Corner{false, edges_[slot(arriving)].curve, 0.5F}}};
  }

  Borders& out_;
  const Cage& cage_;
  const FaceSource& source_;
  const std::vector<ParametricFace>& faces_;
  double tolerance_;
  std::vector<std::uint32_t> first_;  // parametric face of each cage face
  std::vector<Edge> edges_;           // these three: of each corner of each cage face
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint32_t> spokes_;
  std::vector<std::uint32_t> centres_;  // of each cage face
};

Borders::Borders(const Cage& cage, const FaceSource& source, const std::vector<ParametricFace>& faces) {
  BorderBuilder(*this, cage, source, faces);
}

BorderSpot Borders::spot(std::uint32_t face, double u, double v) const {
  const FaceBorder& border = faces_[face];
  const bool on_u = u == 0 || u == 1;
  const bool on_v = v == 0 || v == 1;
  if (on_u && on_v) {
    const Corner& c = border.corners[v == 0 ? (u == 0 ? 0 : 1) : (u == 0 ? 3 : 2)];
    return {c.vertex, c.id, c.t};
  }
  const Side& side = border.sides[on_v ? (v == 0 ? 0 : 2) : (u == 0 ? 3 : 1)];
  return {false, side.curve, static_cast<double>(side.a) + static_cast<double>(side.b) * (on_v ? u : v)};
}

Place Borders::place(const BorderSpot& spot) const {
  if (spot.vertex) return vertices_[spot.id];
  const Piece& p = curves_[spot.id][spot.t <= 0.5 ? 0 : 1];
  return {p.face, static_cast<double>(p.u0) + static_cast<double>(p.du) * spot.t,
          static_cast<double>(p.v0) + static_cast<double>(p.dv) * spot.t};
}

}  // namespace gnomon::surface
