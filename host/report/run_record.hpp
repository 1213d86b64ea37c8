// SPDX-License-Identifier: Apache-2.0
// Everything that is known about one run once it is over: what metrics.json and the report are made of.
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/base/light.hpp"
#include "host/scene/mesh_topology.hpp"
#include "host/voxel/voxel_set.hpp"
#include "sim/system/system_top.hpp"

namespace gnomon::report {

/// One resolved parameter: what was used, and who said so.
struct ParameterValue {
  std::string key;
  nlohmann::ordered_json value;
  std::string unit;    ///< empty where it has none
  std::string origin;  ///< "default", "scene.toml", "--set", ...
  std::string help;    ///< one line
};

/// One object of the scene: its control cage and what became of it.
struct ObjectRecord {
  std::string name;
  bool ground = false;     ///< a receiver added or marked as the ground
  bool two_sided = false;  ///< open surface: resolved with both sides facing
  bool casts = true, receives = true;
  scene::MeshStatistics statistics;
};

/// What came of comparing the engine under test with golden.
struct CompareRecord {
  bool compared = false;        ///< false: golden ran alone
  std::uint64_t words = 0;      ///< result words that both gave
  std::uint64_t differing = 0;  ///< of these
  /// Words that only one gave, event counters that differ, a hang or a failed assertion.
  std::uint64_t other_faults = 0;
  std::string text;  ///< where it failed: several lines that name word, command, cycle and fields of both
  bool software = false;  ///< a technique without hardware: there is nothing to compare
  nlohmann::json first;   ///< the first differing word (docs/report.md), null if there is none
  std::string partial{};  ///< not empty: it was ended before the stream was, and why

  /// A comparison that compared nothing has failed, too.
  bool failed() const { return compared && (words == 0 || differing != 0 || other_faults != 0); }
};

/// "1,234 words compared, 0 differ", or what else there is to say, in one line.
std::string verdict(const CompareRecord& compare);

/// Answers against the exact reference. `samples` is the number of voxels they were counted over.
struct MislabelCounts {
  std::uint64_t samples = 0;
  std::uint64_t false_shadow = 0;  ///< said shadow, exact says lit
  std::uint64_t false_lit = 0;     ///< said lit, exact says shadow
};

/// One method's error against the exact reference on some receivers.
struct ErrorPart {
  MislabelCounts all;                           ///< every voxel
  MislabelCounts unambiguous;                   ///< voxels away from every shadow border
  MislabelCounts steady;                        ///< of these, steady ones (docs/error-metrics.md)
  MislabelCounts samples;                       ///< surface samples, half a voxel apart
  double boundary_length = 0;                   ///< of the exact shadow borders, plane entries
  std::optional<double> boundary_displacement;  ///< mean, plane entries; absent where there is no border
};
struct ErrorRecord {
  ErrorPart total, ground, models;
};

/// How exact the exact reference is, and what it took.
struct ExactRecord {
  std::size_t triangles = 0;
  double sag = 0;   ///< voxels: largest distance between its triangles and the limit surface
  double lift = 0;  ///< voxels by which a ray starts above the surface
  std::uint64_t rays = 0;
};

/// A picture's shadows against the reference picture's.
struct PictureRecord {
  int width = 0, height = 0;           ///< pixels
  MislabelCounts mask;                 ///< picture samples that see a surface
  double intersection_over_union = 1;  ///< of the shadow masks, 0..1
  double rmse = 0;                     ///< of the pictures, 0..1
};

/// The method in double precision, and what fixed point lost against it.
struct DoubleRecord {
  ErrorRecord error;
  std::uint64_t differing = 0;              ///< voxels where fixed and double disagree
  std::uint64_t differing_unambiguous = 0;  ///< of these, unambiguous ones
};

/// A plain shadow map over the same area (docs/error-metrics.md, "Shadow map").
struct ShadowMapRecord {
  std::uint32_t side = 0;         ///< pixels
  std::uint64_t memory_bits = 0;  ///< depth codes alone
  ErrorRecord error;              ///< displacement in the technique's pixels, not in the map's
};

/// As built, and in double where the technique has such a form; what shadow maps would give.
struct ErrorsRecord {
  double pitch = 1;  ///< voxels per entry or pixel, the unit of displacements
  ErrorRecord fixed;
  std::optional<DoubleRecord> in_double;
  std::vector<ShadowMapRecord> shadow_maps;
};

/// Cycles of one pass by cause, both by their names in docs/command-stream.md.
struct PassCycles {
  std::string pass;
  std::map<std::string, std::uint64_t> causes;
};

/// The system around the hardware: processor, firmware, bus, DRAM (docs/system-model.md).
struct SystemRecord {
  std::string hardware;  ///< what answers the commands inside: "core", "golden"
  sim::system::SystemStatistics statistics;
  std::size_t firmware_bytes = 0;                ///< of the image
  std::string log;                               ///< the firmware's
  std::vector<sim::system::JobReport> jobs;      ///< without their results
  std::map<std::string, std::uint64_t> cache{};  ///< counters of its caches; empty without
};

/// One stage of the host, in the order in which they ran.
struct StageTime {
  std::string name;
  double wall_seconds = 0;
  double user_seconds = 0;  ///< user CPU time of the whole process, all threads
};

/// An entry as mem/ stores it: {generation 8, depth 24} (docs/vpu.md).
inline constexpr std::uint64_t kPlaneEntryBits = 32;

/// How the plane was used, after the projection pass; of several views together: after that of each.
struct PlaneRecord {
  std::uint32_t side = 0;  ///< entries
  std::uint64_t entries_hit = 0;
  double pitch = 1;  ///< voxels per entry
  std::uint32_t views = 1;
};

/// How topology mode's lists were used; of several views together.
struct TopologyRecord {
  std::uint32_t side = 0;                        ///< entries
  double pitch = 1;                              ///< voxels per entry
  std::uint64_t lists = 0;                       ///< entries with a list
  std::uint32_t longest = 0;                     ///< nodes
  std::uint64_t head_bits = 0;                   ///< of each entry
  std::uint64_t node_bits = 0, record_bits = 0;  ///< of the whole pools
  std::uint32_t views = 1;
};

/// How the silhouette-line buffer's plane was used; of several views together.
struct SlbRecord {
  std::uint32_t side = 0;                      ///< pixels
  double pitch = 1;                            ///< voxels per pixel
  std::uint64_t entry_bits = 0, row_bits = 0;  ///< of an entry as stored; of the scratch memory's rows, each
  std::uint64_t pixel_scratch_bits = 0;        ///< of the scratch memory, each pixel
  std::array<std::uint64_t, 5> pixels_by_fragments{};  ///< entries with 0..4 fragments; all 0 if not read
  std::uint64_t full_pixels = 0;                       ///< entries with a full depth
  std::uint64_t overflow_pixels = 0;                   ///< entries where something did not fit
  std::uint32_t views = 1;
};

/// What a software technique took (docs/techniques.md); of several views together.
struct SoftwareRecord {
  std::uint32_t side = 0;        ///< texels of a map; 0 for ray casting, as the next two
  std::uint64_t texel_bits = 0;  ///< as stored
  std::uint32_t kernel = 0;      ///< texels read a query, on each axis
  double pitch = 1;              ///< voxels a texel
  std::uint64_t memory_bits = 0;
  std::uint64_t queries = 0;  ///< points asked about: those that face the light
  std::uint64_t drawn = 0;    ///< sheets by texels that they were drawn into
  std::uint64_t bytes_read = 0, bytes_written = 0;
  std::uint64_t triangles = 0;            ///< that rays are cast against
  double build_seconds = 0, seconds = 0;  ///< wall time to make map or hierarchy; to answer
  std::uint32_t views = 1;
};

/// A register as it was programmed.
struct RegisterRecord {
  std::string name;
  std::int64_t value = 0;
  int width = 0;  ///< bits, sign included
  bool is_signed = false;
  int frac_bits = 0;
};

/// One view of a light: what the hardware did for it.
struct ViewRecord {
  std::string name;                             ///< "directional", "spot", "+x" ...
  std::uint64_t casters = 0, receivers = 0;     ///< voxels
  std::map<std::string, std::uint64_t> events;  ///< event counters, this view's share
  std::vector<RegisterRecord> registers;
  std::optional<PlaneRecord> plane;  ///< as in RunRecord; `side` is what this view makes use of
  std::optional<TopologyRecord> topology;
  std::optional<SlbRecord> slb;
  std::optional<SoftwareRecord> software;
};

/// One light: what came out for it alone.
struct LightRecord {
  Light light;                    ///< world coordinates
  std::uint64_t in_shadow = 0;    ///< voxels
  std::uint64_t not_reached = 0;  ///< of these, receivers outside the cone
  ErrorsRecord errors;
  ExactRecord exact;
  MislabelCounts mask;  ///< picture samples that see a surface
  std::vector<ViewRecord> views;
};

/// A camera's way around the scene, after the run.
struct FramesRecord {
  std::size_t count = 0;
  double seconds = 0, user_seconds = 0;               ///< all of them, drawing and writing included
  std::uint64_t command_words = 0, result_words = 0;  ///< that went between host and hardware meanwhile
  std::map<std::string, std::uint64_t> questions;     ///< events: what was asked of answers that are kept
  std::map<std::string, std::uint64_t> shadow_work;   ///< all other events; empty if no shadow was found anew
};

struct RunRecord {
  std::string scene_name;
  std::string scene_source;  ///< the file, as given
  std::string started;       ///< UTC, ISO 8601
  std::vector<std::string> command_line;
  std::vector<std::pair<std::string, std::string>> versions;  ///< tool, version
  std::string engine;                                         ///< the engine whose answers are shown
  std::string technique;
  std::uint64_t seed = 0;
  std::vector<ParameterValue> parameters;
  double clock_mhz = 100;

  voxel::Grid grid;
  std::vector<LightRecord> lights;
  std::vector<ObjectRecord> objects;
  std::vector<std::string> warnings;  ///< what reading the models ignored or repaired
  voxel::VoxelStatistics voxel_statistics;
  std::uint64_t voxels = 0, voxels_in_shadow = 0;  ///< in shadow: summed over the lights

  golden::HardwareConfig hardware;
  std::vector<RegisterRecord> registers;
  std::uint64_t command_words = 0, result_words = 0;
  std::optional<PlaneRecord> plane;  ///< of the projection unit, if the technique uses it
  std::optional<TopologyRecord> topology;
  std::optional<SlbRecord> slb;
  std::optional<SoftwareRecord> software;

  // `plane`, `topology`, `slb`, `registers`, `errors` and `exact` are of all lights together, `registers` of
  // the first view.
  CompareRecord compare;
  std::map<std::string, std::uint64_t> events;  ///< event counters of docs/command-stream.md
  std::vector<PassCycles> cycles;               ///< empty where the engine has no cycles
  /// By the cycle model (docs/cycle-model.md), "cycles.<PASS>.<CAUSE>"; empty without a command stream.
  std::map<std::string, std::uint64_t> predicted_cycles;
  std::optional<SystemRecord> system;  ///< of the system engine
  ErrorsRecord errors;
  ExactRecord exact;
  PictureRecord picture;
  std::optional<FramesRecord> frames;
  std::vector<StageTime> stages;
  std::uint64_t peak_memory_bytes = 0;  ///< of the host program
};

}  // namespace gnomon::report
