// SPDX-License-Identifier: Apache-2.0
// One more ray for every unambiguous voxel that faces the light.
#include "host/metrics/steady_voxels.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

namespace gnomon::metrics {

std::vector<std::uint8_t> steady_voxels(const ExactReference& reference,
                                        std::span<const surface::LimitSurface> surfaces,
                                        const voxel::VoxelSet& voxels, std::span<const Exact> answers,
                                        std::span<const std::uint8_t> unambiguous) {
  if (answers.size() != voxels.voxels.size() || unambiguous.size() != voxels.voxels.size())
    throw std::invalid_argument("one answer and one flag a voxel");
  const auto steady = [&](std::size_t i) {
    const voxel::Voxel& v = voxels.voxels[i];
    const surface::LimitSurface& surface = surfaces[v.object];
    const Vec3 point = surface.evaluate(v.face, double{v.u}, double{v.v}).position;
    const Vec3 normal = surface.normal(v.face, double{v.u}, double{v.v});
    const double cosine = normal.dot(reference.to_light(point));
    if (std::abs(cosine) < kSteadyCosine) return false;
    if (answers[i] != Exact::Lit && answers[i] != Exact::Cast) return true;
    const Vec3 above = point + normal * std::copysign(kSteadyLift, cosine);
    return reference.blocked(above) == (answers[i] == Exact::Cast);
  };
  std::vector<std::uint8_t> result(unambiguous.begin(), unambiguous.end());
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
    if (result[i] != 0) result[i] = steady(i) ? 1 : 0;
  });
  return result;
}

}  // namespace gnomon::metrics
