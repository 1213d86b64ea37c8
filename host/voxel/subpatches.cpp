// SPDX-License-Identifier: Apache-2.0
// Stitches subpatches: every point on a side is collected, by line within a face and by curve between faces.
#include "host/voxel/subpatches.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "host/surface/borders.hpp"

namespace gnomon::voxel {
namespace {

constexpr std::size_t kGrain = 4096;  // quads a task

/// A corner of some subpatch on a line of parameter space: (across, along, voxel).
struct LinePoint {
  float across, along;
  std::uint32_t voxel;
  auto order() const { return std::tie(across, along); }
  bool operator<(const LinePoint& other) const { return order() < other.order(); }
  bool operator==(const LinePoint& other) const { return order() == other.order(); }
};

/// One on a curve between faces.
struct CurvePoint {
  std::uint32_t curve;
  double t;
  std::uint32_t voxel;
  auto order() const { return std::tie(curve, t); }
  bool operator<(const CurvePoint& other) const { return order() < other.order(); }
  bool operator==(const CurvePoint& other) const { return order() == other.order(); }
};

template <class T>
void sort_unique(std::vector<T>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Appends the voxels of the points strictly between two points of a sorted list, in their order or
/// backwards.
template <class T>
void append_between(const std::vector<T>& list, T from, T to, std::vector<std::uint32_t>& out) {
  const bool backwards = to < from;
  if (backwards) std::swap(from, to);
  const auto first = std::upper_bound(list.begin(), list.end(), from);
  const auto last = std::lower_bound(first, list.end(), to);
  const auto begin = static_cast<std::ptrdiff_t>(out.size());
  for (auto p = first; p != last; ++p) out.push_back(p->voxel);
  if (backwards) std::reverse(out.begin() + begin, out.end());
}

struct Corner {
  float u, v;
  std::uint32_t voxel;
};
std::array<Corner, 4> corners(const Subpatch& s) {
  return {{{s.u0, s.v0, s.corner[0]},
           {s.u1, s.v0, s.corner[1]},
           {s.u1, s.v1, s.corner[2]},
           {s.u0, s.v1, s.corner[3]}}};
}
bool at_end(float x) {
  return x == 0 || x == 1;
}

/// The subpatches of one object.
class Stitcher {
 public:
  Stitcher(const surface::LimitSurface& surface, std::span<const Subpatch> subpatches)
      : borders_(surface.borders()), subpatches_(subpatches) {
    for (const Subpatch& s : subpatches_)
      for (const Corner& c : corners(s)) add_border(s.face, c);
    sort_unique(curve_points_);
  }

  /// Calls `visit(polygon)` with the outline of every subpatch, in order. Subpatches of a face are
  /// neighbours in the list.
  template <class Visit>
  void for_each_outline(Visit visit) {
    std::vector<std::uint32_t> polygon;
    for (std::size_t begin = 0, end = 0; begin < subpatches_.size(); begin = end) {
      while (end < subpatches_.size() && subpatches_[end].face == subpatches_[begin].face) ++end;
      const auto face = subpatches_.subspan(begin, end - begin);
      collect_face(face);
      for (const Subpatch& s : face) {
        polygon.clear();
        outline(s, polygon);
        visit(polygon);
      }
    }
  }

 private:
  void add_border(std::uint32_t face, const Corner& c) {
    if (!at_end(c.u) && !at_end(c.v)) return;
    const surface::BorderSpot spot = borders_.spot(face, double{c.u}, double{c.v});
    if (!spot.vertex) curve_points_.push_back({spot.id, spot.t, c.voxel});
  }

  void collect_face(std::span<const Subpatch> face) {
    by_v_.clear();
    by_u_.clear();
    for (const Subpatch& s : face) {
      for (const Corner& c : corners(s)) {
        by_v_.push_back({c.v, c.u, c.voxel});
        by_u_.push_back({c.u, c.v, c.voxel});
      }
    }
    sort_unique(by_v_);
    sort_unique(by_u_);
  }

  void outline(const Subpatch& s, std::vector<std::uint32_t>& out) const {
    const auto c = corners(s);
    for (std::size_t i = 0; i < 4; ++i) {
      const Corner& a = c[i];
      const Corner& b = c[(i + 1) % 4];
      out.push_back(a.voxel);
      const bool along_u = i % 2 == 0;
      if (at_end(along_u ? a.v : a.u)) {
        append_border(s.face, a, b, out);
      } else if (along_u) {
        append_between<LinePoint>(by_v_, {a.v, a.u, 0}, {b.v, b.u, 0}, out);
      } else {
        append_between<LinePoint>(by_u_, {a.u, a.v, 0}, {b.u, b.v, 0}, out);
      }
    }
  }

  // The ends may be vertices, which have no place on the curve: it is found from points inside the side.
  void append_border(std::uint32_t face, const Corner& a, const Corner& b,
                     std::vector<std::uint32_t>& out) const {
    const auto inside = [&](double share) {
      const double u = double{a.u} + (double{b.u} - double{a.u}) * share;
      const double v = double{a.v} + (double{b.v} - double{a.v}) * share;
      return borders_.spot(face, u, v);
    };
    const surface::BorderSpot middle = inside(0.5);
    const double half = (inside(0.75).t - middle.t) * 2;
    append_between<CurvePoint>(curve_points_, {middle.id, middle.t - half, 0},
                               {middle.id, middle.t + half, 0}, out);
  }

  const surface::Borders& borders_;
  std::span<const Subpatch> subpatches_;
  std::vector<CurvePoint> curve_points_;
  std::vector<LinePoint> by_v_, by_u_;  // of the face at hand, by lines of equal v and of equal u
};

/// Drops repeats of a neighbour, cyclically.
void shorten(std::vector<std::uint32_t>& polygon) {
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  while (polygon.size() > 1 && polygon.back() == polygon.front()) polygon.pop_back();
}

bool distinct(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return a != b && b != c && c != a;
}

/// The same points with c3 = c2 where there is but one triangle; c0 = c2 where there is none.
VoxelQuad reduced(const VoxelQuad& q) {
  if (!distinct(q[0], q[2], q[3]) || q[1] == q[3]) {
    return distinct(q[0], q[1], q[2]) ? VoxelQuad{q[0], q[1], q[2], q[2]} : VoxelQuad{};
  }
  return distinct(q[0], q[1], q[2]) ? q : VoxelQuad{q[0], q[2], q[3], q[3]};
}

/// Equal for reduced quads with the same triangles.
VoxelQuad canonical(VoxelQuad q) {
  if (q[3] == q[2]) {
    std::sort(q.begin(), q.begin() + 3);
    q[3] = q[2];
    return q;
  }
  if (q[2] < q[0]) std::swap(q[0], q[2]);
  if (q[3] < q[1]) std::swap(q[1], q[3]);
  return q;
}

void drop_repeats(CastingQuads& out) {
  std::vector<std::pair<VoxelQuad, std::uint32_t>> keys;
  keys.reserve(out.quads.size());
  for (const VoxelQuad& q : out.quads)
    keys.emplace_back(canonical(q), static_cast<std::uint32_t>(keys.size()));
  tbb::parallel_sort(keys.begin(), keys.end());
  std::vector<bool> repeated(keys.size());
  for (std::size_t i = 1; i < keys.size(); ++i)
    if (keys[i].first == keys[i - 1].first) repeated[keys[i].second] = true;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.quads.size(); ++i)
    if (!repeated[i]) out.quads[kept++] = out.quads[i];
  out.statistics.repeated = out.quads.size() - kept;
  out.quads.resize(kept);
}

/// Calls `visit(polygon)` with the outline of every subpatch, in order.
template <class Visit>
void for_each_outline(std::span<const surface::LimitSurface> surfaces, std::span<const Subpatch> all,
                      Visit visit) {
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    const std::uint32_t object = all[begin].object;
    while (end < all.size() && all[end].object == object) ++end;
    Stitcher(surfaces[object], all.subspan(begin, end - begin)).for_each_outline(visit);
  }
}

/// Calls `visit(quad)` for quads around the polygon's first point.
template <class Visit>
void for_each_quad(const std::vector<std::uint32_t>& polygon, Visit visit) {
  for (std::size_t i = 1; i + 1 < polygon.size(); i += 2) {
    const std::size_t last = std::min(i + 2, polygon.size() - 1);
    visit(VoxelQuad{polygon[0], polygon[i], polygon[i + 1], polygon[last]});
  }
}

}  // namespace

CastingQuads casting_quads(std::span<const surface::LimitSurface> surfaces, const VoxelSet& set) {
  CastingQuads out;
  out.statistics.subpatches = set.subpatches.size();
  for_each_outline(surfaces, set.subpatches, [&](std::vector<std::uint32_t>& polygon) {
    if (polygon.size() > 4) ++out.statistics.stitched;
    shorten(polygon);
    if (polygon.size() < 3) ++out.statistics.degenerate;
    for_each_quad(polygon, [&](const VoxelQuad& quad) {
      const VoxelQuad kept = reduced(quad);
      if (kept[0] == kept[2])
        ++out.statistics.degenerate;
      else
        out.quads.push_back(kept);
    });
  });
  drop_repeats(out);
  return out;
}

std::vector<LimitQuad> limit_quads(std::span<const surface::LimitSurface> surfaces, const VoxelSet& set) {
  // Corners are numbered one by one, so that each of them can be found again.
  std::vector<Subpatch> numbered = set.subpatches;
  std::uint32_t next = 0;
  for (Subpatch& s : numbered)
    for (std::uint32_t& corner : s.corner) corner = next++;
  const auto point = [&](std::uint32_t number) {
    const Subpatch& s = set.subpatches[number / 4];
    const Corner c = corners(s)[number % 4];
    return surfaces[s.object].position(s.face, double{c.u}, double{c.v});
  };
  std::vector<LimitQuad> out;
  for_each_outline(surfaces, numbered, [&](const std::vector<std::uint32_t>& polygon) {
    for_each_quad(polygon, [&](const VoxelQuad& quad) { out.push_back({{}, quad}); });
  });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, out.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& part) {
                      for (std::size_t q = part.begin(); q < part.end(); ++q) {
                        for (std::size_t i = 0; i < 4; ++i) {
                          std::uint32_t& number = out[q].voxels[i];
                          out[q].points[i] = point(number);
                          number = set.subpatches[number / 4].corner[number % 4];
                        }
                      }
                    });
  return out;
}

}  // namespace gnomon::voxel
