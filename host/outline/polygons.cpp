// SPDX-License-Identifier: Apache-2.0
// Outlines of polygon meshes: triangles face the light or do not, edges add up.
#include <algorithm>
#include <map>

#include "host/outline/ears.hpp"
#include "host/outline/facing.hpp"
#include "host/outline/loops.hpp"
#include "host/outline/partition.hpp"
#include "host/outline/sides.hpp"
#include "host/outline/thinning.hpp"

namespace gnomon::outline {
namespace {

/// A side of a triangle; `low` < `high` are its vertices.
struct Side {
  std::uint32_t low, high, triangle;
  int direction;  ///< 1: from low to high
};

bool same_edge(const Side& a, const Side& b) {
  return a.low == b.low && a.high == b.high;
}

std::vector<Side> sorted_sides(std::span<const Triangle> triangles) {
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangles[t][k];
      const std::uint32_t b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b ? 1 : -1});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

bool triangle_faces_light(const scene::ControlMesh& mesh, const Triangle& t, const LightView& view) {
  const Vec3& a = mesh.positions[t[0]];
  const Vec3 n = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
  const double length = n.length();
  return length > 0 && faces_light(n.dot(view.to_light()) / length);
}

class PolygonOutliner {
 public:
  PolygonOutliner(const scene::ControlMesh& mesh, const LightView& view)
      : view_(view), triangles_(triangles_of(mesh)), sides_(sorted_sides(triangles_)) {
    for (const Triangle& t : triangles_) plus_.push_back(triangle_faces_light(mesh, t, view));
    for (const Vec3& p : mesh.positions) graph_.add(view.vertex(p));
    find_parts();
    choose_sides();
  }

  ObjectOutline run(std::uint32_t object) {
    out_.object = object;
    out_.statistics.faces = triangles_.size();
    for_each_edge([&](std::span<const Side> edge) {
      int times = 0;
      for (const Side& s : edge)
        times += s.direction * stretch_times(sides_to_send_[part_[s.triangle]], plus_[s.triangle]);
      graph_.add(edge.front().low, edge.front().high, times);
      out_.statistics.border_vertices += times != 0 ? 1 : 0;
    });
    for (Loop& loop : link_loops(graph_)) keep(loop);
    return std::move(out_);
  }

 private:
  template <class Visit>
  void for_each_edge(Visit visit) const {
    for (std::span<const Side> rest(sides_); !rest.empty();) {
      std::size_t n = 1;
      while (n < rest.size() && same_edge(rest[0], rest[n])) ++n;
      visit(rest.first(n));
      rest = rest.subspan(n);
    }
  }

  void find_parts() {
    Partition parts(triangles_.size());
    for_each_edge([&](std::span<const Side> edge) {
      for (const Side& s : edge) parts.join(edge.front().triangle, s.triangle);
    });
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) part_.push_back(parts.find(t));
  }

  void choose_sides() {
    std::map<std::uint32_t, std::vector<BoundaryPiece>> boundaries;
    for_each_edge([&](std::span<const Side> edge) {
      int sum = 0;
      for (const Side& s : edge) sum += s.direction;
      if (sum != 0)
        boundaries[part_[edge.front().triangle]].push_back(
            {at(edge.front().low), at(edge.front().high), sum});
      if (edge.size() == 1) ++out_.statistics.boundary_edges;
      if (edge.size() > 2 || (edge.size() == 2 && sum != 0)) ++out_.statistics.non_manifold_edges;
    });
    sides_to_send_.assign(triangles_.size(), Sides::Facing);
    for (const auto& [part, pieces] : boundaries) {
      sides_to_send_[part] = sides_to_send(pieces, view_.mirrored());
      out_.statistics.doubled_parts += sides_to_send_[part] == Sides::Both ? 1U : 0U;
    }
    out_.statistics.open_parts = boundaries.size();
  }

  Vec2 at(std::uint32_t vertex) const { return {graph_.points[vertex].x, graph_.points[vertex].y}; }

  void keep(Loop& loop) {
    if (on_a_line(loop)) {
      ++out_.statistics.dropped_loops;
      return;
    }
    if (view_.mirrored()) std::reverse(loop.begin() + 1, loop.end());
    out_.statistics.vertices += loop.size();
    out_.loops.push_back(std::move(loop));
  }

  const LightView& view_;
  std::vector<Triangle> triangles_;
  std::vector<Side> sides_;
  std::vector<bool> plus_;            // of each triangle
  std::vector<std::uint32_t> part_;   // of each triangle
  std::vector<Sides> sides_to_send_;  // of parts
  ArcGraph graph_;
  ObjectOutline out_;
};

}  // namespace

Result<std::vector<ObjectOutline>> outlines_of_polygons(std::span<const scene::ControlMesh> meshes,
                                                        const LightFrame& frame) {
  if (const auto error = check(frame)) return tl::make_unexpected(*error);
  const LightView view(frame);
  std::vector<ObjectOutline> out;
  for (std::uint32_t i = 0; i < meshes.size(); ++i) out.push_back(PolygonOutliner(meshes[i], view).run(i));
  return out;
}

}  // namespace gnomon::outline
