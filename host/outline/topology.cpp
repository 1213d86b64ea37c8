// SPDX-License-Identifier: Apache-2.0
// Asks the borders where sides lie, joins faces that share a curve, and adds up directions.
#include "host/outline/topology.hpp"

#include <algorithm>

#include "host/outline/partition.hpp"
#include "host/surface/borders.hpp"

namespace gnomon::outline {
namespace {

/// Side parameters are exact at small dyadics, so two of them give the whole map.
SideOnCurve locate(const surface::Borders& borders, std::uint32_t face, std::uint32_t side) {
  const double across = side == 1 || side == 2 ? 1 : 0;
  const auto spot = [&](double s) {
    return side % 2 == 0 ? borders.spot(face, s, across) : borders.spot(face, across, s);
  };
  const surface::BorderSpot low = spot(0.25);
  const double b = (spot(0.75).t - low.t) * 2;
  return {low.id, low.t - 0.25 * b, b};
}

/// What lies on one half of a curve: the edges of n-gons are divided in the middle.
struct Half {
  std::uint32_t sides = 0;
  int sum = 0;  ///< of their directions, as the faces' borders run
  std::uint32_t face = 0;
};

class TopologyFinder {
 public:
  explicit TopologyFinder(const surface::LimitSurface& surface)
      : parts_(surface.face_count()), halves_(std::size_t{2} * surface.borders().curve_count()) {
    out_.curves = surface.borders().curve_count();
    out_.sides.resize(surface.face_count());
    for (std::uint32_t face = 0; face < surface.face_count(); ++face)
      for (std::uint32_t side = 0; side < 4; ++side) {
        out_.sides[face][side] = locate(surface.borders(), face, side);
        enter(face, side);
      }
  }

  Topology run() {
    for (std::uint32_t face = 0; face < out_.sides.size(); ++face) out_.part.push_back(parts_.find(face));
    std::vector<bool> open(out_.sides.size(), false);
    for (std::uint32_t i = 0; i < halves_.size(); ++i) {
      const Half& half = halves_[i];
      if (half.sum == 0) continue;
      const double t0 = i % 2 == 0 ? 0 : 0.5;
      out_.boundary.push_back({i / 2, t0, t0 + 0.5, half.sum, out_.part[half.face]});
      open[out_.part[half.face]] = true;
    }
    count();
    out_.counts.open_parts = static_cast<std::size_t>(std::count(open.begin(), open.end(), true));
    return std::move(out_);
  }

 private:
  void enter(std::uint32_t face, std::uint32_t side) {
    const SideOnCurve& on = out_.sides[face][side];
    const int direction = (side < 2) == (on.b > 0) ? 1 : -1;
    for (const std::uint32_t half : {0U, 1U}) {
      const double middle = half == 0 ? 0.25 : 0.75;
      if (middle < std::min(on.at(0), on.at(1)) || middle > std::max(on.at(0), on.at(1))) continue;
      Half& h = halves_[std::size_t{2} * on.curve + half];
      if (h.sides++ == 0) h.face = face;
      h.sum += direction;
      parts_.join(h.face, face);
    }
  }

  void count() {
    out_.counts.faces = out_.sides.size();
    for (std::size_t c = 0; c < out_.curves; ++c) {
      // A curve counts once, by the half where more happens.
      const Half& h = std::max(halves_[2 * c], halves_[2 * c + 1],
                               [](const Half& a, const Half& b) { return a.sides < b.sides; });
      if (h.sides == 1) ++out_.counts.boundary_edges;
      if (h.sides > 2 || (h.sides == 2 && h.sum != 0)) ++out_.counts.non_manifold_edges;
    }
  }

  Partition parts_;
  std::vector<Half> halves_;
  Topology out_;
};

}  // namespace

Topology find_topology(const surface::LimitSurface& surface) {
  return TopologyFinder(surface).run();
}

}  // namespace gnomon::outline
