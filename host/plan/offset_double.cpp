// SPDX-License-Identifier: Apache-2.0
// The offset-based test in double precision, on exact positions and normals: the method without its
// quantisation.
#include <algorithm>
#include <cmath>
#include <limits>

#include "host/plan/representative.hpp"
#include "host/plan/vpu_plan.hpp"

namespace gnomon::plan {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();
/// Normals are stored in single precision: a cosine below this says nothing about the side that faces the
/// light.
constexpr double kGrazing = 1e-6;

Vec3 normal(const voxel::Voxel& voxel) {
  return {double{voxel.normal[0]}, double{voxel.normal[1]}, double{voxel.normal[2]}};
}

/// The plane of nearest depths, in depth codes but not rounded to them.
class DepthPlane {
 public:
  explicit DepthPlane(const Projection& projection)
      : projection_(projection),
        side_(projection.plane_side),
        nearest_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), kNothing) {}

  void project(const Vec3& p) {
    if (projection_.behind(p)) return;
    if (double* entry = find(p)) *entry = std::min(*entry, projection_.depth(p));
  }
  /// Nearest depth in the entry that p falls into; infinite where empty or off the plane.
  double nearest(const Vec3& p) const {
    const double* entry = const_cast<DepthPlane*>(this)->find(p);
    if (entry == nullptr) return kNothing;
    return *entry;
  }

 private:
  double* find(const Vec3& p) {
    const Vec2 e = projection_.entry(p);
    const double u = std::floor(e.x), v = std::floor(e.y);
    if (!(u >= 0 && v >= 0 && u < side_ && v < side_)) return nullptr;
    return &nearest_[static_cast<std::size_t>(v) * static_cast<std::size_t>(side_) +
                     static_cast<std::size_t>(u)];
  }

  const Projection& projection_;
  int side_;
  std::vector<double> nearest_;
};

/// How much farther than the nearest depth of its entry the offset point must be, in depth codes: a slope's
/// share of an entry (docs/vpu.md). `a` is the voxel's point, `n` its normal, turned to the light.
double margin(const VpuPlan& plan, const Vec3& a, const Vec3& n) {
  const Projection& p = plan.projection;
  const VpuSettings& s = plan.settings;
  if (!p.perspective) {
    const Vec3 beam = p.beam(a);
    const double cosine = -n.dot(beam);
    const double tangent = std::min((n + beam * cosine).length() / cosine, s.margin_tan_max);
    return std::max(s.margin * p.codes_per_voxel * tangent, 0.0);
  }
  const double entries = s.margin / s.pitch;
  const Vec3 across = n - p.axis * n.dot(p.axis);
  const double slope = across.length() / -n.dot(a - p.eye);  // of 1/z, per unit of the angle's tangent
  const double most = s.margin_tan_max / p.z(a);
  return entries * p.key_scale * p.w_scale / p.entries_a_slope * std::min(slope, most);
}

}  // namespace

std::vector<golden::VoxelState> offset_states_double(const VpuPlan& plan, const voxel::VoxelSet& voxels,
                                                     const ViewVoxels& seen,
                                                     const std::vector<bool>& two_sided) {
  const Projection& projection = plan.projection;
  DepthPlane plane(projection);
  for (const std::uint32_t i : seen.casters) plane.project(representative(voxels.voxels[i]));

  const auto state = [&](const voxel::Voxel& voxel) {
    const Vec3 a = representative(voxel);
    if (projection.behind(a)) return golden::VoxelState::Shadow;
    Vec3 n = normal(voxel);
    double cosine = -n.dot(projection.beam(a));
    if (two_sided[voxel.object] && cosine < 0) {
      n = -n;
      cosine = -cosine;
    }
    if (cosine <= kGrazing) return golden::VoxelState::Shadow;
    if (!(plane.nearest(a) < projection.depth(a))) return golden::VoxelState::Lit;
    const Vec3 moved = a + n * plan.settings.offset_factor;
    if (projection.behind(moved)) return golden::VoxelState::Lit;
    const double delta = projection.depth(moved) - plane.nearest(moved);  // -infinity where empty
    return delta > margin(plan, a, n) ? golden::VoxelState::Shadow : golden::VoxelState::Lit;
  };
  std::vector<golden::VoxelState> states(seen.receivers.size());
  std::transform(seen.receivers.begin(), seen.receivers.end(), states.begin(),
                 [&](std::uint32_t i) { return state(voxels.voxels[i]); });
  return states;
}

}  // namespace gnomon::plan
