// SPDX-License-Identifier: Apache-2.0
// The bias is what a plane through the receiver rises within half a pixel's diagonal: a flat receiver never
// shadows itself.
#include "host/metrics/shadow_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host/metrics/voxel_index.hpp"

namespace gnomon::metrics {
namespace {

constexpr double kMaxSlope = 10;     ///< where the bias stops growing
constexpr double kCurvature = 0.01;  ///< voxels: of the receiver within a pixel, and rounding

double slope_of(double facing) {
  return std::min(kMaxSlope, std::sqrt(std::max(0.0, 1 - facing * facing)) / facing);
}

}  // namespace

ShadowMap::ShadowMap(const ExactReference& reference, const LightPlane& plane)
    : reference_(reference), plane_(plane) {
  if (!std::holds_alternative<DirectionalLight>(reference.light()))
    throw std::invalid_argument("a plain shadow map is for a directional light");
}

bool ShadowMap::in_shadow(const Vec3& point, double facing) const {
  if (!(facing > 0)) return true;
  const Vec2 at = plane_.pixel(point);
  const Vec2 centre(std::floor(at.x) + 0.5, std::floor(at.y) + 0.5);
  if (std::min(centre.x, centre.y) < 0 || std::max(centre.x, centre.y) > plane_.side) return false;
  const Vec3 aside = plane_.axes.right * ((centre.x - at.x) * plane_.pitch) +
                     plane_.axes.up * ((centre.y - at.y) * plane_.pitch);
  const double bias = std::sqrt(0.5) * plane_.pitch * slope_of(facing) + kCurvature;
  return reference_.blocked(point + aside - plane_.axes.away * bias);
}

std::vector<golden::VoxelState> ShadowMap::states(const voxel::VoxelSet& voxels,
                                                  const std::vector<bool>& two_sided) const {
  std::vector<golden::VoxelState> states(voxels.voxels.size());
  tbb::parallel_for(std::size_t{0}, states.size(), [&](std::size_t i) {
    const voxel::Voxel& v = voxels.voxels[i];
    const double cosine = -representative_normal(v).dot(plane_.axes.away);
    const bool dark = in_shadow(representative(v), two_sided.at(v.object) ? std::abs(cosine) : cosine);
    states[i] = dark ? golden::VoxelState::Shadow : golden::VoxelState::Lit;
  });
  return states;
}

SampleAnswers ShadowMap::answers(const ShadowTruth& truth) const {
  const auto all = [this](std::span<const SurfaceSample> samples) {
    std::vector<std::uint8_t> shadowed(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t i) {
      const SurfaceSample& s = samples[i];
      shadowed[i] = in_shadow(Vec3(s.x, s.y, s.z), double{s.facing}) ? 1 : 0;
    });
    return shadowed;
  };
  return {all(truth.samples), all(truth.border_samples)};
}

}  // namespace gnomon::metrics
