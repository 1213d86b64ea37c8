// SPDX-License-Identifier: Apache-2.0
// The light's direction, and cosines of normals with it.
#include "host/outline/facing.hpp"

#include <algorithm>
#include <cmath>

namespace gnomon::outline {
namespace {

/// Sines of the angle between the tangents below which the surface itself is asked for a normal.
constexpr double kSmallestSine = 1e-9;

/// Volume of the rows by the product of their lengths, below which they count as lying in a plane.
constexpr double kFlat = 1e-9;

}  // namespace

std::optional<Error> check(const LightFrame& f) {
  for (const Vec3& row : {f.x, f.y, f.depth, Vec3(f.x1, f.y1, f.depth1)})
    if (!std::isfinite(row.x) || !std::isfinite(row.y) || !std::isfinite(row.z))
      return Error{"outline: the light frame has a number that is not finite"};
  const double size = f.x.length() * f.y.length() * f.depth.length();
  if (!(std::abs(f.x.cross(f.y).dot(f.depth)) > kFlat * size))
    return Error{"outline: the light frame's three rows do not span space"};
  return std::nullopt;
}

LightView::LightView(const LightFrame& frame) : frame_(frame) {
  const Vec3 across = frame.x.cross(frame.y);
  mirrored_ = across.dot(frame.depth) > 0;
  to_light_ = (mirrored_ ? -across : across).normalized();
  scale_ = std::max(frame.x.length(), frame.y.length());
  codes_per_pixel_ = std::abs(frame.depth.dot(to_light_)) / scale_;
}

Vertex LightView::vertex(const Vec3& p) const {
  const Vec2 xy = frame_.pixel(p);
  return {xy.x, xy.y, frame_.code(p)};
}

Stance stance(const surface::LimitSurface& surface, const LightView& view, const surface::Place& place) {
  const surface::SurfacePoint p = surface.evaluate(place.face, place.u, place.v);
  const Vec3 n = p.du.cross(p.dv);
  const double length = n.length();
  if (length > kSmallestSine * p.du.length() * p.dv.length() && length > 0)
    return {n.dot(view.to_light()) / length, p.du, p.dv};
  return {surface.normal(place.face, place.u, place.v).dot(view.to_light()), p.du, p.dv};
}

}  // namespace gnomon::outline
