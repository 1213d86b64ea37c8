// SPDX-License-Identifier: Apache-2.0
// Plain counting; every comparison is counted, so that none can be left out unseen.
#include "host/metrics/shadow_error.hpp"

#include <stdexcept>

namespace gnomon::metrics {
namespace {

template <class T>
T& receiver(ByReceiver<T>& by, std::uint32_t object, const ErrorOptions& options) {
  return options.ground && *options.ground == object ? by.ground : by.models;
}

void count(Mislabels& counts, bool shadowed, bool exact) {
  ++counts.compared;
  if (shadowed && !exact) ++counts.false_shadow;
  if (!shadowed && exact) ++counts.false_lit;
}

void expect_size(std::size_t given, std::size_t expected, const char* what) {
  if (given != expected)
    throw std::invalid_argument(std::to_string(given) + " " + what + " given, " + std::to_string(expected) +
                                " expected");
}

bool is_shadow(golden::VoxelState state) {
  if (state != golden::VoxelState::Lit && state != golden::VoxelState::Shadow)
    throw std::invalid_argument("a voxel's state is neither lit nor shadow");
  return state == golden::VoxelState::Shadow;
}

}  // namespace

Mislabels& Mislabels::operator+=(const Mislabels& other) {
  compared += other.compared;
  false_shadow += other.false_shadow;
  false_lit += other.false_lit;
  return *this;
}

double Displacement::entries() const {
  const double length = border_cast + border_attached;
  return length > 0 ? (area_cast + area_attached) / length / pitch : 0.0;
}

Displacement& Displacement::operator+=(const Displacement& other) {
  area_cast += other.area_cast;
  area_attached += other.area_attached;
  border_cast += other.border_cast;
  border_attached += other.border_attached;
  return *this;
}

SampleAnswers sample_answers(const ShadowTruth& truth, std::span<const golden::VoxelState> states) {
  const auto answers = [&](std::span<const SurfaceSample> samples) {
    std::vector<std::uint8_t> shadowed(samples.size());
    for (std::size_t i = 0; i < shadowed.size(); ++i) {
      const std::uint32_t voxel = samples[i].voxel;
      // Surface without a voxel is never shadowed by a technique that knows voxels alone.
      shadowed[i] = voxel != kNoVoxel && is_shadow(states[voxel]) ? 1 : 0;
    }
    return shadowed;
  };
  return {answers(truth.samples), answers(truth.border_samples)};
}

ByReceiver<Mislabels> sample_mislabels(const ShadowTruth& truth, std::span<const std::uint8_t> shadowed,
                                       const ErrorOptions& options) {
  expect_size(shadowed.size(), truth.samples.size(), "sample answers");
  ByReceiver<Mislabels> result;
  for (std::size_t i = 0; i < shadowed.size(); ++i) {
    const SurfaceSample& s = truth.samples[i];
    count(receiver(result, s.object, options), shadowed[i] != 0, in_shadow(s.exact));
  }
  return result;
}

ByReceiver<Displacement> displacement(const ShadowTruth& truth, const SampleAnswers& answers,
                                      const ErrorOptions& options) {
  expect_size(answers.samples.size(), truth.samples.size(), "sample answers");
  expect_size(answers.border.size(), truth.border_samples.size(), "border sample answers");
  ByReceiver<Displacement> result;
  result.ground.pitch = result.models.pitch = options.pitch;
  for (std::uint32_t object = 0; object < truth.border.size(); ++object) {
    Displacement& to = receiver(result, object, options);
    to.border_cast += truth.border[object].cast;
    to.border_attached += truth.border[object].attached;
  }
  const auto add = [&](const SurfaceSample& s, bool shadowed) {
    if (shadowed == in_shadow(s.exact)) return;
    Displacement& to = receiver(result, s.object, options);
    (s.exact == Exact::Attached ? to.area_attached : to.area_cast) += double{s.light_area};
  };
  for (std::size_t i = 0; i < truth.samples.size(); ++i) {
    if (truth.on_border[i] == 0) add(truth.samples[i], answers.samples[i] != 0);
  }
  for (std::size_t i = 0; i < truth.border_samples.size(); ++i)
    add(truth.border_samples[i], answers.border[i] != 0);
  return result;
}

ShadowErrors shadow_errors(const ShadowTruth& truth, const voxel::VoxelSet& voxels,
                           std::span<const golden::VoxelState> states, const ErrorOptions& options) {
  expect_size(states.size(), truth.voxels.size(), "voxel states");
  return shadow_errors(truth, voxels, states, sample_answers(truth, states), options);
}

ShadowErrors shadow_errors(const ShadowTruth& truth, const voxel::VoxelSet& voxels,
                           std::span<const golden::VoxelState> states, const SampleAnswers& answers,
                           const ErrorOptions& options) {
  expect_size(voxels.voxels.size(), truth.voxels.size(), "voxels");
  expect_size(states.size(), truth.voxels.size(), "voxel states");
  ShadowErrors errors;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::uint32_t object = voxels.voxels[i].object;
    if (truth.receives[object] == 0) continue;
    const bool shadowed = is_shadow(states[i]);
    const bool exact = in_shadow(truth.voxels[i]);
    count(receiver(errors.all_voxels, object, options), shadowed, exact);
    if (truth.unambiguous[i] != 0)
      count(receiver(errors.unambiguous_voxels, object, options), shadowed, exact);
    if (truth.steady[i] != 0) count(receiver(errors.steady_voxels, object, options), shadowed, exact);
  }
  errors.samples = sample_mislabels(truth, answers.samples, options);
  errors.displacement = displacement(truth, answers, options);
  return errors;
}

}  // namespace gnomon::metrics
