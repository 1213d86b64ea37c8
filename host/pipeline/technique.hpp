// SPDX-License-Identifier: Apache-2.0
// What a way to decide shadows does in a run: hardware and stream out of a scene, answers out of results.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/config.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "host/base/light_plane.hpp"
#include "host/base/receiver.hpp"
#include "host/base/result.hpp"
#include "host/pipeline/engines.hpp"
#include "host/pipeline/run.hpp"
#include "host/render/picture.hpp"
#include "host/report/run_record.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

/// The scene as techniques see it, in grid coordinates. What it refers to outlives the technique.
struct TechniqueInput {
  std::span<const surface::LimitSurface> surfaces;
  const std::vector<bool>& two_sided;  ///< by object
  const voxel::VoxelSet& voxels;
  Vec3 light;  ///< the way it travels
};

/// What came out, in the order of what went in.
struct Answers {
  std::vector<golden::VoxelState> voxels;  ///< Lit or Shadow at each voxel's representative
  std::vector<std::uint8_t> points;        ///< 1 for shadow, one a receiver; empty if it knows voxels alone
};

class Technique {
 public:
  virtual ~Technique() = default;

  virtual const golden::HardwareConfig& config() const = 0;
  /// Answers at any point, not only at voxels.
  virtual bool answers_points() const = 0;
  /// All commands of the run, from reset. `points` is empty unless answers_points().
  virtual Result<std::vector<golden::Word>> stream(std::span<const Receiver> points) = 0;
  /// The answers among all results of that stream.
  virtual Result<Answers> decode(std::span<const golden::Word> results) const = 0;
  /// The method in double precision at the voxels; nothing where there is no such thing.
  virtual std::optional<std::vector<golden::VoxelState>> in_double() const = 0;
  /// Voxels per entry or pixel of the plane in which displacements are measured.
  virtual double pitch() const = 0;
  /// Shadow maps over the same area that it is to be measured against.
  virtual std::vector<LightPlane> shadow_maps() const { return {}; }
  /// Its part of the record, once golden has run.
  virtual void describe(const EngineAnswers& golden, report::RunRecord& record) const = 0;
  /// What its memory holds, if that is worth looking at.
  virtual std::optional<render::Image> memory_picture(std::span<const golden::Word>) const {
    return std::nullopt;
  }
};

/// The technique named in the settings; errors name the setting that is to be changed.
Result<std::unique_ptr<Technique>> make_technique(const RunSettings& settings, const TechniqueInput& input);

}  // namespace gnomon::pipeline
