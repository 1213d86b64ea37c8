// SPDX-License-Identifier: Apache-2.0
// The main job: from a scene to shadows, checked word by word, with a picture, figures and a report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/plan/vpu_plan.hpp"
#include "host/report/run_record.hpp"
#include "host/scene/scene.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

enum class EngineKind : std::uint8_t {
  Golden,  ///< the golden model alone: nothing is compared, no cycles
  Rtl,     ///< the Verilated unit, compared with golden word for word
};

/// What the user may choose; the names are those of the parameters of `gnomon params`.
struct RunSettings {
  std::uint32_t res = 256;
  voxel::Adjacency adjacency = voxel::Adjacency::N26;
  std::string technique = "voxel-offset";  ///< the only one so far
  plan::VpuSettings vpu;
  double clock_mhz = 100;  ///< the clock at which cycles are told as time
  int image_width = 960;   ///< pixels
  int image_height = 720;  ///< pixels
  unsigned threads = 0;    ///< 0: all cores
};

/// Called with the stage's name and 0..1, from one thread at a time.
using Progress = std::function<void(std::string_view stage, double done)>;

/// Makes an engine for a piece of hardware.
using EngineFactory = std::function<Result<std::unique_ptr<golden::Engine>>(const golden::HardwareConfig&)>;

struct RunRequest {
  scene::Scene scene;
  RunSettings settings;
  EngineKind engine = EngineKind::Rtl;
  std::filesystem::path output;  ///< directory, made if missing; an older run's results in it are replaced
  std::uint64_t seed = 1;        ///< reset values of the rtl engine

  // What the report says about where the run came from.
  std::vector<std::string> command_line;           ///< reproduces this run
  std::vector<report::ParameterValue> parameters;  ///< all of them, resolved
  std::vector<report::StageTime> earlier_stages;   ///< what was timed before: "load"

  Progress progress;     ///< may be empty
  std::stop_token stop;  ///< a stop ends the run with an Error and leaves nothing behind

  /// Engines other than the usual ones, for tests: the definition, and the one under test.
  EngineFactory make_golden, make_tested;
};

struct RunOutcome {
  std::uint64_t words = 0;      ///< result words compared
  std::uint64_t differing = 0;  ///< of these (and of the event counters); 0 is what everybody wants
  std::optional<report::Difference> first_difference;
  nlohmann::ordered_json metrics;  ///< what metrics.json holds (docs/report.md)
  std::filesystem::path output;    ///< where the report lies

  /// The program's exit status: 0 all comparisons hold, 1 one failed.
  int exit_status() const { return differing == 0 ? 0 : 1; }
};

/// Does the whole job and leaves in `request.output`: report.html, image.png, reference.png, error.png,
/// metrics.json, voxels.npy and stream.gnomon, all or none of them. A failed comparison is an outcome, not an
/// error: the report is written and shows it. Errors are what the user can cure: settings that make no legal
/// hardware, a scene without a surface, an output directory that cannot be written, a stop.
Result<RunOutcome> run(const RunRequest& request);

/// "1,234 words compared, 0 differ", or what was not compared: the report's verdict in one line.
std::string verdict(const RunOutcome& outcome);

}  // namespace gnomon::pipeline
