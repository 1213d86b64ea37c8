// SPDX-License-Identifier: Apache-2.0
// What the silhouette-line buffer is asked in a run, and its answers.
#include "host/pipeline/slb_answers.hpp"

#include <tbb/parallel_for.h>

#include <gnomon/golden/slb/codec.hpp>
#include <gnomon/golden/stream.hpp>

#include "host/metrics/voxel_index.hpp"

namespace gnomon::pipeline {
namespace {

constexpr std::uint64_t kScratchBits = 11;  // a pixel: docs/slb.md, "Scratch memory"
constexpr std::uint64_t kCarryBits = 8;     // a row

/// The normal is evaluated: the stored one is single precision, too coarse for walls along the light's way.
Receiver at_representative(const voxel::Voxel& v, const surface::LimitSurface& surface, const Vec3& light,
                           bool two_sided) {
  const Vec3 p = metrics::representative(v);
  const double cosine = -surface.normal(v.face, double{v.u}, double{v.v}).dot(light.normalized());
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
          static_cast<float>(two_sided ? std::abs(cosine) : cosine)};
}

}  // namespace

std::vector<Receiver> voxel_receivers(std::span<const surface::LimitSurface> surfaces,
                                      const voxel::VoxelSet& voxels, const plan::ObjectRoles& roles,
                                      const plan::LightView& view, const plan::ViewVoxels& seen) {
  std::vector<Receiver> receivers(seen.receivers.size());
  tbb::parallel_for(std::size_t{0}, receivers.size(), [&](std::size_t i) {
    const voxel::Voxel& v = voxels.voxels[seen.receivers[i]];
    receivers[i] = at_representative(v, surfaces[v.object], view.axes.away, roles.two_sided[v.object]);
  });
  return receivers;
}

Result<std::vector<golden::slb::QueryAnswer>> query_answers(std::span<const golden::Word> results,
                                                            std::size_t expected) {
  std::vector<golden::slb::QueryAnswer> answers;
  answers.reserve(expected);
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    if (golden::result_code(result->word) == golden::ResultCode::Error)
      return fail("the hardware refused a command: " + golden::describe_result(result->word));
    if (static_cast<std::uint8_t>(result->word >> 56) == golden::slb::kAnswerCode)
      answers.push_back(golden::slb::decode_answer(result->word));
  }
  return answers;
}

report::SlbRecord slb_record(const plan::SlbPlan& plan, const golden::HardwareConfig& config) {
  report::SlbRecord use;
  use.side = static_cast<std::uint32_t>(plan.plane.side);
  use.pitch = plan.plane.pitch;
  use.entry_bits = static_cast<std::uint64_t>(config.slb_config().stored_entry_bits());
  use.pixel_scratch_bits = kScratchBits;
  use.row_bits = kCarryBits;
  return use;
}

}  // namespace gnomon::pipeline
