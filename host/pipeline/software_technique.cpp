// SPDX-License-Identifier: Apache-2.0
// What the software techniques have in common: receivers in, answers out, the time that takes.
#include "host/pipeline/software_technique.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "host/metrics/voxel_index.hpp"

namespace gnomon::pipeline {
namespace {

using golden::VoxelState;

template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

golden::HardwareConfig no_hardware(int depth_bits) {
  golden::HardwareConfig config;
  config.en_vpu_offset = false;
  config.depth_bits = depth_bits;
  return config;
}

}  // namespace

bool is_software(std::string_view technique) {
  constexpr std::array<std::string_view, 3> kAll{"plain-map", "pcf", "raycast"};
  return std::ranges::find(kAll, technique) != kAll.end();
}

SoftwareTechnique::SoftwareTechnique(const TechniqueInput& input, int depth_bits)
    : input_(input), config_(no_hardware(depth_bits)) {}

Result<void> SoftwareTechnique::write(golden::StreamWriter&, const golden::HardwareConfig&,
                                      std::span<const Receiver> points) {
  const std::vector<std::uint32_t>& voxels = input_.seen.receivers;
  receivers_.resize(voxels.size());
  tbb::parallel_for(std::size_t{0}, voxels.size(), [&](std::size_t i) {
    const voxel::Voxel& v = input_.voxels.voxels[voxels[i]];
    const Vec3 p = metrics::representative(v);
    const Vec3 normal = input_.surfaces[v.object].normal(v.face, double{v.u}, double{v.v});
    receivers_[i] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                     static_cast<float>(exact().facing(p, normal, v.object))};
  });
  if (input_.first) receivers_.insert(receivers_.end(), points.begin(), points.end());
  asked_ = static_cast<std::uint64_t>(std::ranges::count_if(receivers_, &Receiver::faces_light));
  return {};
}

std::vector<std::uint8_t> SoftwareTechnique::answered(std::span<const Receiver> points) const {
  std::vector<std::uint8_t> shadowed(points.size(), 1);
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    if (points[i].faces_light()) shadowed[i] = in_shadow(points[i]) ? 1 : 0;
  });
  return shadowed;
}

void SoftwareTechnique::solve() {
  build_seconds_ = seconds_of([&] { build(); });
  seconds_ = seconds_of([&] { answers_ = answered(receivers_); });
}

Result<Answers> SoftwareTechnique::decode(std::span<const golden::Word>) const {
  const auto voxels = static_cast<std::ptrdiff_t>(input_.seen.receivers.size());
  Answers all;
  all.voxels.reserve(input_.seen.receivers.size());
  for (auto at = answers_.begin(); at != answers_.begin() + voxels; ++at)
    all.voxels.push_back(*at != 0 ? VoxelState::Shadow : VoxelState::Lit);
  all.points.assign(answers_.begin() + voxels, answers_.end());
  return all;
}

Result<std::vector<std::uint8_t>> SoftwareTechnique::answers(std::span<const golden::Word>,
                                                             std::span<const Receiver> points,
                                                             std::span<const golden::Word>) const {
  return answered(points);
}

void SoftwareTechnique::describe(const PartAnswers&, std::span<const golden::Word>,
                                 report::ViewRecord& record) const {
  report::SoftwareRecord& software = record.software.emplace();
  software.queries = asked_;
  software.build_seconds = build_seconds_;
  software.seconds = seconds_;
  describe(software);
}

}  // namespace gnomon::pipeline
