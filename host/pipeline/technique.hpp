// SPDX-License-Identifier: Apache-2.0
// What a way to decide shadows does in a run: hardware and stream out of a scene, answers out of results.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/stream.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/base/light_plane.hpp"
#include "host/base/receiver.hpp"
#include "host/base/result.hpp"
#include "host/metrics/exact_reference.hpp"
#include "host/pipeline/engines.hpp"
#include "host/pipeline/run.hpp"
#include "host/pipeline/scene_quads.hpp"
#include "host/plan/light_view.hpp"
#include "host/render/picture.hpp"
#include "host/report/run_record.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

/// One view of one light over the scene, in grid coordinates. What it refers to outlives the technique.
struct TechniqueInput {
  std::span<const surface::LimitSurface> surfaces;
  const plan::ObjectRoles& roles;
  const voxel::VoxelSet& voxels;
  SceneQuads& quads;
  const plan::LightView& view;
  const plan::ViewVoxels& seen;
  std::size_t light = 0;  ///< number of the light that the view belongs to
  bool first = true;      ///< of its light's views
  /// The light's exact shadows, which are there once the scene has been looked at; null: not to be had.
  const std::optional<metrics::ExactReference>* exact = nullptr;
};

/// What came out, in the order of what went in.
struct Answers {
  std::vector<golden::VoxelState> voxels;  ///< Lit or Shadow at each receiver's representative
  std::vector<std::uint8_t> points;        ///< 1 for shadow, one a point; empty if it knows voxels alone
};

/// A way to decide shadows, in one view of one light.
class Technique {
 public:
  virtual ~Technique() = default;

  /// The hardware that this view alone asks for.
  virtual const golden::HardwareConfig& config() const = 0;
  /// Answers at any point, not only at voxels.
  virtual bool answers_points() const = 0;
  /// All commands of the view but the closing fence. `hardware` is the writer's, that of all views
  /// (joined_hardware). `points` is empty unless answers_points().
  virtual Result<void> write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                             std::span<const Receiver> points) = 0;
  /// The answers among the results of these commands.
  virtual Result<Answers> decode(std::span<const golden::Word> results) const = 0;
  /// Commands that ask about more points, for hardware that has executed those of write() last. Only if
  /// answers_points(), else std::logic_error, as the next.
  virtual void ask(golden::StreamWriter& writer, std::span<const Receiver> points) const;
  /// Their answers among `results`, 1 for shadow, one a point; `run` are the results that decode() takes.
  virtual Result<std::vector<std::uint8_t>> answers(std::span<const golden::Word> results,
                                                    std::span<const Receiver> points,
                                                    std::span<const golden::Word> run) const;
  /// True for what no hardware runs: write() gives no commands, no engine is made, and what decode() gives is
  /// found by solve(), which is called in between.
  virtual bool is_software() const { return false; }
  virtual void solve() {}
  /// Of a software technique: what its model counts (docs/techniques.md, "Costs"), once solved.
  virtual std::vector<report::PassCycles> cycles() const { return {}; }
  /// The method in double precision at the receivers; nothing where there is no such thing.
  virtual std::optional<std::vector<golden::VoxelState>> in_double() const = 0;
  /// Voxels per entry or pixel of the plane in which displacements are measured.
  virtual double pitch() const = 0;
  /// The same on the plane that metrics::LightScale measures on: at distance 1 from a light that has a place.
  virtual double pitch_on_plane() const { return pitch(); }
  /// Shadow maps over the same area that it is to be measured against.
  virtual std::vector<LightPlane> shadow_maps() const { return {}; }
  /// Its part of the view's record, once golden has run; `results` are the view's.
  virtual void describe(const PartAnswers& golden, std::span<const golden::Word> results,
                        report::ViewRecord& record) const = 0;
  /// What its memory holds, if that is worth looking at.
  virtual std::optional<render::Image> memory_picture(std::span<const golden::Word>) const {
    return std::nullopt;
  }
};

/// One hardware for several views: the largest of every size, every unit that some view needs.
golden::HardwareConfig joined_hardware(golden::HardwareConfig a, const golden::HardwareConfig& b);

/// The technique `name`, an object a view; all views together ask for one hardware. Errors name the setting
/// that is to be changed.
Result<std::vector<std::unique_ptr<Technique>>> make_techniques(const std::string& name,
                                                                const RunSettings& settings,
                                                                std::span<const TechniqueInput> views);

/// Fails where a technique does not know a light of the scene, naming both.
Result<void> check_lights(const scene::Scene& scene, std::span<const std::string> techniques);

}  // namespace gnomon::pipeline
