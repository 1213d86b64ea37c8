// SPDX-License-Identifier: Apache-2.0
// The main job: from a scene to shadows, checked word by word, with a picture, figures and a report.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/mesh/mesh_files.hpp"
#include "host/plan/slb_settings.hpp"
#include "host/plan/topology_plan.hpp"
#include "host/plan/vpu_plan.hpp"
#include "host/report/run_record.hpp"
#include "host/scene/scene.hpp"
#include "host/voxel/voxel_set.hpp"
#include "sim/rtl_engine.hpp"
#include "sim/system/system_engine.hpp"

namespace gnomon::pipeline {

enum class EngineKind : std::uint8_t {
  Golden,  ///< the golden model alone: nothing is compared, no cycles
  Rtl,     ///< the Verilated unit, compared with golden word for word
  System,  ///< the same within a system of processor, firmware, bus and DRAM
};

/// "golden", "rtl", "system".
std::string_view to_string(EngineKind engine);
/// Nothing for any other word.
std::optional<EngineKind> engine_of(std::string_view word);

/// Of plain-map and pcf (docs/techniques.md).
struct MapSettings {
  std::string memory = "slb";  ///< the hardware technique whose memory the map has
  int side = 0;                ///< texels; 0: as many as fit into that memory
  int kernel = 3;              ///< texels that pcf reads on each axis
};

/// What the user may choose; the names are those of the parameters of `gnomon params`.
struct RunSettings {
  std::uint32_t res = 256;
  voxel::Adjacency adjacency = voxel::Adjacency::N26;
  /// Of "voxel-offset", "voxel-topology", "slb", "slb+voxel", "plain-map", "pcf", "raycast", each once; the
  /// first leads the report.
  std::vector<std::string> techniques{"voxel-offset"};
  plan::VpuSettings vpu;
  plan::TopologySettings topology;
  plan::SlbSettings slb;
  plan::ItemOrder order = plan::ItemOrder::Surface;  ///< of voxels, quads and points in the stream
  MapSettings maps;
  double ray_sag = 1.0 / 512;  ///< voxels: of raycast's own tessellation
  bool frame_buffer = false;   ///< states are kept by the hardware and looked up (docs/frame-buffer.md)
  sim::system::SystemOptions system;  ///< of the system engine; `rtl` comes with the request
  bool memory_given = false;  ///< somebody has said what its memory is like: golden predicts its cycles
  double clock_mhz = 100;     ///< the clock at which cycles are told as time
  int image_width = 960;      ///< pixels
  int image_height = 720;     ///< pixels
  unsigned threads = 0;       ///< 0: all cores
};

/// Called with the stage's name and 0..1, from one thread at a time.
using Progress = std::function<void(std::string_view stage, double done)>;

/// Makes the engine that defines the answers.
using GoldenFactory = std::function<std::unique_ptr<golden::Engine>(const golden::HardwareConfig&)>;
/// Makes the engine under test.
using RtlFactory =
    std::function<std::unique_ptr<sim::RtlEngine>(const golden::HardwareConfig&, const sim::RtlOptions&)>;

struct RunRequest {
  scene::Scene scene;
  RunSettings settings;
  EngineKind engine = EngineKind::Rtl;
  std::filesystem::path output;  ///< directory, made if missing; an older run's results in it are replaced
  std::uint32_t seed = 1;        ///< reset values of the rtl engine
  /// Pictures from a camera that goes once around its target, the first from where it is; 0: none.
  std::uint32_t frames = 0;
  std::vector<mesh::MeshFormat> meshes;  ///< of the surfaces with their shadows

  // What the report says about where the run came from.
  std::vector<std::string> command_line;                      ///< reproduces this run
  std::vector<report::ParameterValue> parameters;             ///< all of them, resolved
  std::vector<report::StageTime> earlier_stages;              ///< what was timed before: "load"
  std::vector<std::pair<std::string, std::string>> versions;  ///< tool, version; the program itself first

  Progress progress;  ///< may be empty
  /// Cycles after which the simulation ends; the report says that its comparison is partial.
  std::uint64_t max_cycles = UINT64_MAX;
  std::optional<sim::TraceWindow> trace;  ///< of the engine under test; with one technique
  /// Gets what happens in the system engine, as lines of JSON (docs/system-model.md); may be empty.
  std::function<void(const std::string& line)> on_event;

  /// True ends the run with an Error and leaves nothing behind; while the engine under test runs, it ends
  /// that, and the report says so. Not owned.
  const std::atomic<bool>* abort = nullptr;

  // Other engines than the usual ones, for tests; empty: golden::make_golden_engine and
  // make_engine_under_test.
  GoldenFactory make_golden;
  RtlFactory make_rtl;
};

struct RunOutcome {
  /// Of the first technique whose comparison failed, else of the first.
  report::CompareRecord compare;
  nlohmann::ordered_json metrics;  ///< what metrics.json holds (docs/report.md)
  std::filesystem::path output;    ///< where the report lies
  bool interrupted = false;        ///< `abort` has ended the engine under test

  /// The program's exit status: 0 all comparisons hold, 1 one failed; report::verdict says so in one line.
  int exit_status() const { return compare.failed() ? 1 : 0; }
};

/// Does the whole job and leaves in `request.output`: report.html, image.png, reference.png, error.png,
/// metrics.json, voxels.npy and stream.gnomon, all or none of them; of each further technique T image-T.png,
/// error-T.png, voxels-T.npy and stream-T.gnomon; where asked for, frames/frame_0000.png and so on
/// (frames-T/) and mesh.obj, mesh.ply (mesh-T.ply). A failed comparison is an outcome, not an error: the
/// report is written and shows it. Errors are what the user can cure: settings that make no legal hardware, a
/// light that a technique does not know, an output directory that cannot be written, no compiler for the rtl
/// engine, an interruption.
Result<RunOutcome> run(const RunRequest& request);

}  // namespace gnomon::pipeline
