// SPDX-License-Identifier: Apache-2.0
// Every rounding between the scene and the SLB's words stands here.
#include "host/plan/slb_stream.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace gnomon::plan {
namespace {

constexpr double kMaxSlope = 5;         // voxels of depth a voxel aside; steeper sheets are nearly edge-on
constexpr double kCurvature = 2;        // a sheet's range in a pixel against that of a sample's tangent plane
constexpr double kSampleSpacing = 0.6;  // pixels
constexpr double kReceiverBias = 0.02;  // voxels
constexpr double kMarginPixels = 1;

std::uint32_t depth_code(const SlbPlan& plan, double code) {
  const double last = std::ldexp(1.0, plan.config.depth_bits) - 2;
  return static_cast<std::uint32_t>(std::clamp(code, 0.0, last));
}

/// Nearest; loops may reach a plane's width beyond the plane on each side.
std::int64_t subpixels(const SlbPlan& plan, double pixels) {
  return std::llround(std::ldexp(pixels, plan.config.subpixel_bits));
}

golden::slb::Vertex vertex(const SlbPlan& plan, const outline::Vertex& v) {
  return {subpixels(plan, v.x), subpixels(plan, v.y), depth_code(plan, std::ceil(v.depth))};
}

/// What a sheet spans in depth inside one pixel, as one sample of it tells. Depth codes.
struct Span {
  std::int64_t row, column;
  double sample;
  double near, far;  ///< estimates of the sheet's range
};

/// Twice the range of the sample's tangent plane in its pixel, on either side: sheets are curved.
Span span_of(const SlbPlan& plan, const SheetSample& sample) {
  const LightAxes& axes = plan.plane.axes;
  const Vec2 at = plan.plane.pixel(sample.point);
  const Vec2 pixel(std::floor(at.x), std::floor(at.y));
  // Depth over right and up: normal.(right dx + up dy + away dd) = 0.
  const double along = sample.normal.dot(axes.away);
  const double steep = std::max(std::abs(along), 1e-9) * (along < 0 ? 1 : -1);
  double rise = 0;
  double fall = 0;
  for (const auto& [axis, inside] :
       {std::pair(axes.right, at.x - pixel.x), std::pair(axes.up, at.y - pixel.y)}) {
    const double slope = std::clamp(sample.normal.dot(axis) / steep, -kMaxSlope, kMaxSlope);
    rise += slope > 0 ? slope * (1 - inside) : -slope * inside;
    fall += slope > 0 ? slope * inside : -slope * (1 - inside);
  }
  const double scale = kCurvature * plan.plane.pitch * plan.codes_per_voxel;
  const double code = plan.code(sample.point);
  return {static_cast<std::int64_t>(pixel.y), static_cast<std::int64_t>(pixel.x), code, code - fall * scale,
          code + rise * scale};
}

/// The sheet that spans [first, last) are samples of; depth rounded up.
golden::slb::CoverSample sheet_of(const SlbPlan& plan, const Span* first, const Span* last) {
  const auto before = [](const auto member) {
    return [member](const Span& a, const Span& b) { return a.*member < b.*member; };
  };
  golden::slb::CoverSample sheet;
  sheet.column = first->column;
  sheet.row = first->row;
  sheet.depth = depth_code(plan, std::ceil(std::max_element(first, last, before(&Span::far))->far));
  const double front = std::min_element(first, last, before(&Span::sample))->sample;
  // The least range that reaches the front.
  const std::uint32_t reach = sheet.depth - std::min(sheet.depth, depth_code(plan, std::floor(front)));
  sheet.range = static_cast<std::uint32_t>(std::bit_width(reach));
  return sheet;
}

golden::slb::QueryPoint query_point(const SlbPlan& plan, const Receiver& receiver) {
  const Vec3 p(receiver.x, receiver.y, receiver.z);
  const Vec2 at = plan.plane.pixel(p);
  // The field holds two planes' width on either side of the origin; off the plane, how far does not matter.
  const double limit = 2.0 * plan.plane.side;
  const auto coordinate = [&](double pixels) {
    const double inside = std::clamp(pixels, -limit, limit - 1);
    return static_cast<std::int64_t>(std::floor(std::ldexp(inside, plan.config.query_bits)));
  };
  return {coordinate(at.x), coordinate(at.y), depth_code(plan, std::floor(plan.code(p)))};
}

}  // namespace

std::vector<SheetSample> sheet_samples(const SlbPlan& plan, const surface::LimitSurface& surface,
                                       const voxel::VoxelSet& voxels, std::uint32_t object, bool two_sided) {
  std::vector<SheetSample> samples;
  for (const voxel::Subpatch& p : voxels.subpatches) {
    if (p.object != object) continue;
    // Its own corners: the voxels that they fell into may be represented by points elsewhere.
    const auto at = [&](float u, float v) {
      return plan.plane.pixel(surface.position(p.face, double{u}, double{v}));
    };
    const std::array<Vec2, 4> corner{at(p.u0, p.v0), at(p.u1, p.v0), at(p.u1, p.v1), at(p.u0, p.v1)};
    const auto count = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
      const double longest = std::max((corner[b] - corner[a]).length(), (corner[d] - corner[c]).length());
      return std::max(1, static_cast<int>(std::ceil(longest / kSampleSpacing)));
    };
    const int nu = count(0, 1, 3, 2);
    const int nv = count(0, 3, 1, 2);
    for (int j = 0; j < nv; ++j)
      for (int i = 0; i < nu; ++i) {
        const double u = p.u0 + (double{p.u1} - p.u0) * (i + 0.5) / nu;
        const double v = p.v0 + (double{p.v1} - p.v0) * (j + 0.5) / nv;
        const Vec3 normal = surface.normal(p.face, u, v);
        if (!two_sided && normal.dot(plan.plane.axes.away) >= 0) continue;
        samples.push_back({surface.position(p.face, u, v), normal});
      }
  }
  return samples;
}

std::vector<golden::slb::CoverSample> cover_samples(const SlbPlan& plan,
                                                    std::span<const SheetSample> samples) {
  std::vector<Span> spans;  // those of a pixel that overlap are one sheet
  spans.reserve(samples.size());
  for (const SheetSample& sample : samples) spans.push_back(span_of(plan, sample));
  std::ranges::sort(spans, std::greater{},
                    [](const Span& s) { return std::tuple(s.row, s.column, s.far, s.near); });
  std::vector<golden::slb::CoverSample> sheets;
  for (std::size_t first = 0; first < spans.size();) {
    double near = spans[first].near;
    std::size_t last = first + 1;
    while (last < spans.size() && spans[last].row == spans[first].row &&
           spans[last].column == spans[first].column && spans[last].far >= near) {
      near = std::min(near, spans[last].near);
      ++last;
    }
    sheets.push_back(sheet_of(plan, &spans[first], spans.data() + last));
    first = last;
  }
  return sheets;
}

void draw_casters(golden::StreamWriter& writer, const SlbPlan& plan,
                  std::span<const outline::ObjectOutline> outlines,
                  std::span<const std::vector<golden::slb::CoverSample>> sheets) {
  const auto margin = static_cast<std::uint32_t>(
      std::ceil((std::sqrt(3.0) + kMarginPixels * plan.plane.pitch) * plan.codes_per_voxel));
  writer.slb_clear();
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    writer.begin_object(static_cast<std::uint8_t>(outlines[i].object));
    for (const outline::Loop& loop : outlines[i].loops) {
      std::vector<golden::slb::Vertex> vertices;
      vertices.reserve(loop.size());
      for (const outline::Vertex& v : loop) vertices.push_back(vertex(plan, v));
      writer.loop(vertices);
    }
    if (!outlines[i].loops.empty()) {
      writer.fill();
      writer.cover(sheets[i], margin);
    }
    writer.end_object();
  }
}

std::vector<std::uint32_t> asking_order(const SlbPlan& plan, std::span<const Receiver> receivers,
                                        ItemOrder order) {
  if (order == ItemOrder::Surface) return {};
  std::vector<std::uint32_t> tiles(receivers.size());
  std::ranges::transform(receivers, tiles.begin(),
                         [&](const Receiver& r) { return tile_of(plan.plane.pixel(Vec3(r.x, r.y, r.z))); });
  return by_tile(tiles);
}

void ask_receivers(golden::StreamWriter& writer, const SlbPlan& plan, std::span<const Receiver> receivers,
                   std::span<const std::uint32_t> places) {
  std::vector<golden::slb::QueryPoint> points;
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    const Receiver& receiver = receivers[places.empty() ? i : places[i]];
    if (receiver.faces_light()) points.push_back(query_point(plan, receiver));
  }
  writer.query(points, static_cast<std::uint32_t>(std::ceil(kReceiverBias * plan.codes_per_voxel)));
}

}  // namespace gnomon::plan
