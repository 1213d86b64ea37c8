// SPDX-License-Identifier: Apache-2.0
// How far a technique's answers are from the exact ones: counts, areas and displacement. Definitions:
// docs/error-metrics.md.
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <optional>
#include <span>
#include <vector>

#include "host/metrics/shadow_truth.hpp"

namespace gnomon::metrics {

/// Answers compared with exact ones, and those that differ.
struct Mislabels {
  std::uint64_t compared = 0;
  std::uint64_t false_shadow = 0;  ///< exact: lit
  std::uint64_t false_lit = 0;     ///< exact: in shadow
  std::uint64_t wrong() const { return false_shadow + false_lit; }
  double share() const {
    return compared ? static_cast<double>(wrong()) / static_cast<double>(compared) : 0.0;
  }
  Mislabels& operator+=(const Mislabels& other);
  bool operator==(const Mislabels&) const = default;
};

/// A quantity on the ground object, on everything else, and on both.
template <class T>
struct ByReceiver {
  T ground{}, models{};
  T total() const {
    T sum = ground;
    sum += models;
    return sum;
  }
};

/// Wrongly answered surface in the light's projection plane, and the border it lies along, in the units of
/// LightScale and their squares.
struct Displacement {
  double area_cast = 0;        ///< wrong where the surface faces the light
  double area_attached = 0;    ///< wrong where it faces away
  double border_cast = 0;      ///< length of the exact cast border
  double border_attached = 0;  ///< length of the exact terminators
  double pitch = 1;            ///< side of a plane entry
  /// Mean boundary displacement, plane entries: all wrong area over all border. 0 where there is no border.
  double entries() const;
  Displacement& operator+=(const Displacement& other);
};

struct ShadowErrors {
  ByReceiver<Mislabels> all_voxels;
  ByReceiver<Mislabels> unambiguous_voxels;
  ByReceiver<Mislabels> steady_voxels;
  ByReceiver<Mislabels> samples;  ///< per surface sample, unweighted
  ByReceiver<Displacement> displacement;
};

/// `ground` names the object counted as ground, if there is one. `pitch` is the side of a plane entry, in the
/// units of LightScale: voxels for a directional light, else what an entry measures at distance 1.
struct ErrorOptions {
  std::optional<std::uint32_t> ground;
  double pitch = 1;
};

/// Compares the voxel states of objects that receive; a sample's answer is the state of its voxel. `states`
/// runs as the truth's voxels; any state other than Lit and Shadow, or a wrong number of states, throws
/// std::invalid_argument.
ShadowErrors shadow_errors(const ShadowTruth& truth, const voxel::VoxelSet& voxels,
                           std::span<const golden::VoxelState> states, const ErrorOptions& options);

/// What a technique answers at the truth's samples: 1 for shadow.
struct SampleAnswers {
  std::vector<std::uint8_t> samples;  ///< runs as truth.samples
  std::vector<std::uint8_t> border;   ///< runs as truth.border_samples
};

/// The answers where voxels answer. `states` as in shadow_errors.
SampleAnswers sample_answers(const ShadowTruth& truth, std::span<const golden::VoxelState> states);

/// For techniques that answer at any point. A wrong number of answers throws std::invalid_argument.
ByReceiver<Displacement> displacement(const ShadowTruth& truth, const SampleAnswers& answers,
                                      const ErrorOptions& options);
ByReceiver<Mislabels> sample_mislabels(const ShadowTruth& truth, std::span<const std::uint8_t> shadowed,
                                       const ErrorOptions& options);

/// As shadow_errors, with the technique's own answers at the samples instead of the voxels'.
ShadowErrors shadow_errors(const ShadowTruth& truth, const voxel::VoxelSet& voxels,
                           std::span<const golden::VoxelState> states, const SampleAnswers& answers,
                           const ErrorOptions& options);

}  // namespace gnomon::metrics
