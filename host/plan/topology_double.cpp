// SPDX-License-Identifier: Apache-2.0
// Lists by bounding box, and the published test on every quad that is wholly nearer.
#include "host/plan/topology_double.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "host/plan/representative.hpp"

namespace gnomon::plan {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
/// Normals are stored in single precision: a cosine below this says nothing about the side that faces the
/// light.
constexpr double kGrazing = 1e-6;

constexpr std::size_t kGrain = 4096;  // voxels a task

/// What some voxels took.
struct Effort {
  std::uint64_t uncertain = 0, tested = 0;
  friend Effort operator+(const Effort& a, const Effort& b) {
    return {a.uncertain + b.uncertain, a.tested + b.tested};
  }
};

/// Quads by plane entry, one array for all lists.
class Lists {
 public:
  Lists(const Projection& projection, std::span<const voxel::LimitQuad> quads)
      : projection_(projection), side_(projection.plane_side), far_(quads.size(), -kNothing) {
    starts_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    for (std::size_t i = 0; i < quads.size(); ++i) {
      for (const Vec3& p : quads[i].points) far_[i] = std::max(far_[i], projection.depth(p));
      for_each_entry(quads[i], [&](std::size_t entry) { ++starts_[entry + 1]; });
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    members_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < quads.size(); ++i)
      for_each_entry(quads[i],
                     [&](std::size_t entry) { members_[next[entry]++] = static_cast<std::uint32_t>(i); });
  }

  std::span<const std::uint32_t> at(const Vec3& p) const {
    const Vec2 e = projection_.entry(p);
    const double u = std::floor(e.x), v = std::floor(e.y);
    if (!(u >= 0 && v >= 0 && u < side_ && v < side_)) return {};
    const std::size_t entry = index(static_cast<int>(u), static_cast<int>(v));
    return std::span(members_).subspan(starts_[entry], starts_[entry + 1] - starts_[entry]);
  }
  double far(std::uint32_t quad) const { return far_[quad]; }

 private:
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(u);
  }
  template <class Visit>
  void for_each_entry(const voxel::LimitQuad& quad, Visit visit) const {
    if (std::ranges::any_of(quad.points, [&](const Vec3& p) { return projection_.behind(p); })) return;
    Vec2 low(kNothing, kNothing), high(-kNothing, -kNothing);
    for (const Vec3& p : quad.points) {
      const Vec2 e = projection_.entry(p);
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], std::floor(e[axis]));
        high[axis] = std::max(high[axis], std::floor(e[axis]));
      }
    }
    const auto clipped = [&](double x) {
      return static_cast<int>(std::clamp(x, -1.0, static_cast<double>(side_)));
    };
    for (int v = std::max(clipped(low.y), 0); v <= std::min(clipped(high.y), side_ - 1); ++v)
      for (int u = std::max(clipped(low.x), 0); u <= std::min(clipped(high.x), side_ - 1); ++u)
        visit(index(u, v));
  }

  const Projection& projection_;
  int side_;
  std::vector<double> far_;
  std::vector<std::size_t> starts_;
  std::vector<std::uint32_t> members_;
};

}  // namespace

double published_distance(const Vec3& start, const Vec3& direction, const Vec3& v0, const Vec3& v1,
                          const Vec3& v2) {
  const Vec3 u = v1 - v0, v = v2 - v0;
  const Vec3 normal = u.cross(v);
  const double along = normal.dot(direction);
  if (along == 0) return kNothing;
  const double distance = normal.dot(v0 - start) / along;
  const Vec3 w = start + direction * distance - v0;
  const double uv = u.dot(v), uu = u.dot(u), vv = v.dot(v), wu = w.dot(u), wv = w.dot(v);
  const double below = uv * uv - uu * vv;
  const double s = (uv * wv - vv * wu) / below;
  const double t = (uv * wu - uu * wv) / below;
  if (!(s >= 0 && t >= 0 && s + t <= 1)) return kNothing;
  return distance;
}

TopologyDouble topology_states_double(const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                                      std::span<const voxel::LimitQuad> quads,
                                      std::span<const std::uint32_t> receivers,
                                      const std::vector<bool>& two_sided, double lift) {
  const Projection& projection = plan.vpu.projection;

  const Lists lists(projection, quads);
  TopologyDouble out;

  const auto hit = [&](const Vec3& start, const voxel::LimitQuad& quad) {
    const auto& p = quad.points;
    const Vec3 beam = projection.beam(start);
    const double light = projection.perspective ? (start - projection.eye).length() : kNothing;
    const auto nearer = [&](double distance) { return distance > 0 && distance < light; };
    return nearer(published_distance(start, -beam, p[0], p[1], p[2])) ||
           nearer(published_distance(start, -beam, p[0], p[2], p[3]));
  };
  const auto state = [&](const voxel::Voxel& voxel, Effort& effort) {
    Vec3 n(double{voxel.normal[0]}, double{voxel.normal[1]}, double{voxel.normal[2]});
    if (projection.behind(representative(voxel))) return golden::VoxelState::Shadow;
    const Vec3 beam = projection.beam(representative(voxel));
    if (two_sided[voxel.object] && n.dot(beam) > 0) n = -n;
    if (-n.dot(beam) <= kGrazing) return golden::VoxelState::Shadow;
    const Vec3 start = representative(voxel) + n * lift;
    if (projection.behind(start)) return golden::VoxelState::Lit;
    const double depth = projection.depth(start) - plan.settings.clearance * projection.codes_a_voxel(start);
    bool uncertain = false, shadow = false;
    for (const std::uint32_t i : lists.at(start)) {
      if (lists.far(i) >= depth) continue;
      uncertain = true;
      ++effort.tested;
      shadow = hit(start, quads[i]);
      if (shadow) break;
    }
    effort.uncertain += uncertain ? 1U : 0U;
    return shadow ? golden::VoxelState::Shadow : golden::VoxelState::Lit;
  };
  out.states.resize(receivers.size());
  const Effort total = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, receivers.size(), kGrain), Effort{},
      [&](const tbb::blocked_range<std::size_t>& part, Effort effort) {
        for (std::size_t i = part.begin(); i < part.end(); ++i)
          out.states[i] = state(voxels.voxels[receivers[i]], effort);
        return effort;
      },
      std::plus<>());
  out.uncertain = total.uncertain;
  out.tested = total.tested;
  return out;
}

}  // namespace gnomon::plan
