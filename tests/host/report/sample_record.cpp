// SPDX-License-Identifier: Apache-2.0
// A run as it might have been, with every field set.
#include "tests/host/report/sample_record.hpp"

namespace gnomon::report {
namespace {

ErrorPart part(std::uint64_t voxels, std::uint64_t wrong, std::optional<double> boundary) {
  return {{voxels, wrong / 3, wrong - wrong / 3},
          {voxels * 9 / 10, wrong / 12, wrong / 20},
          {voxels * 8 / 10, wrong / 13, wrong / 21},
          {4 * voxels, wrong, 3 * wrong},
          812.5,
          boundary};
}

ErrorRecord error_record(std::uint64_t wrong) {
  return {part(217000, 2 * wrong, 0.147), part(92000, wrong, 0.121), part(125000, wrong, std::nullopt)};
}

}  // namespace

RunRecord sample_record() {
  RunRecord r;
  r.scene_name = "sundial <1>";
  r.scene_source = "scenes/sundial & co.obj";
  r.command_line = {"gnomon", "run", "scenes/sundial & co.obj", "--set", "res=128", "-o", "it's out"};
  r.started = "2031-02-03T04:05:06Z";
  r.versions = {{"gnomon", "0.1.0-12-gabcdef0"}, {"Verilator", "5.006"}, {"compiler", "GNU 12.2.0"}};
  r.engine = "rtl";
  r.technique = "voxel-offset";
  r.seed = 7;
  r.parameters = {{"res", 128, "voxels", "command line", "side of the voxel grid"},
                  {"adjacency", 26, "neighbours", "default", "when two voxels are neighbours"},
                  {"ground", "on", "", "scene.toml:7", "put a ground under the models"},
                  {"light", {0.45, -1, -0.4}, "", "default", "the way the light travels"}};
  r.clock_mhz = 125;
  r.grid = {128, Vec3(-1.5, -1, -1.25), 0.0234375, voxel::Adjacency::N26};
  r.lights.emplace_back().light = DirectionalLight{Vec3(0, -1, 0)};
  scene::MeshStatistics cage;
  cage.vertices = 2930;
  cage.faces = 2928;
  cage.quads = 2928;
  cage.edges = 5856;
  cage.extraordinary_vertices = 60;
  cage.largest_valence = 8;
  cage.non_manifold_edges = 2;
  r.objects = {{"gnomon", false, false, true, true, cage}, {"ground", true, true, true, true, {}}};
  r.warnings = {"scenes/sundial.obj:12: vt and vn are not used"};
  r.voxel_statistics = {260000, 219000, 0, 3, 0.021};
  r.voxels = 217000;
  r.voxels_in_shadow = 71000;
  r.hardware.voxel_bits = 7;
  r.registers = {{"MATRIX_UX", 1048576, 24, true, 22}, {"OFFSET_FACTOR", 1455, 18, false, 16}};
  r.command_words = 434030;
  r.plane = PlaneRecord{256, 31000, 1.0};
  r.errors.pitch = 1.0;
  r.compare = {true, 217001, 0, 0, "", false, nullptr};
  r.events = {{"COMMANDS", 13},
              {"VOXELS_PROJECTED", 217000},
              {"PROJECT_OFF_PLANE", 0},
              {"VOXELS_RESOLVED", 217000},
              {"RESOLVED_SHADOW", 71000},
              {"RESOLVED_UNCERTAIN", 52000},
              {"RESOLVED_FACING_AWAY", 50000}};
  r.cycles = {{"IDLE", {{"IDLE", 12}}},
              {"CONTROL", {{"BUSY", 26}, {"HAZARD", 40}}},
              {"CLEAR", {{"BUSY", 4096}}},
              {"PROJECT", {{"BUSY", 217004}, {"HAZARD", 130}}},
              {"RESOLVE", {{"BUSY", 217008}, {"OUTPUT_BLOCKED", 1900}, {"MEMORY_WAIT", 25}}},
              {"READ", {}}};
  r.errors = {1.0, error_record(940), DoubleRecord{error_record(925), 61, 4}, {}};
  r.exact = {181000, 0.0009, 0.002, 3400000};
  r.picture = {960, 720, {1800000, 5200, 4100}, 0.981, 0.0123};
  r.frames = FramesRecord{36, 18.0, 32.4, 7000, 6936, {{"SLB_QUERIES", 6900}}, {}};
  r.stages = {
      {"load", 0.004, 0.004},          {"surface", 0.031, 0.05},      {"voxelize", 0.021, 0.04},
      {"plan", 0.012, 0.012},          {"golden engine", 0.05, 0.05}, {"rtl model", 0.02, 0.01},
      {"rtl engine", 0.11, 0.11},      {"decode", 0.002, 0.002},      {"double reference", 0.02, 0.02},
      {"exact reference", 1.2, 2.3},   {"errors", 0.04, 0.04},        {"picture", 0.4, 0.79},
      {"reference picture", 0.5, 0.9}, {"error map", 0.01, 0.01}};
  return r;
}

RunRecord slb_record() {
  RunRecord r = sample_record();
  r.technique = "slb";
  r.plane.reset();
  r.errors.in_double.reset();
  r.errors.pitch = 0.6;
  r.errors.shadow_maps = {{256, std::uint64_t{256} * 256 * 20, error_record(5000)},
                          {32768, 21474836480, error_record(900)}};
  r.hardware.en_slb = true;
  r.hardware.en_vpu_offset = false;
  r.slb = SlbRecord{256, 0.6, 256, 8, 11, {60000, 5000, 536, 0, 0}, 23903, 3};
  r.events = {{"SLB_CROSSINGS", 2000},
              {"SLB_QUERIES", 1000000},
              {"SLB_QUERIES_OVERFLOW", 250},
              {"SLB_FILL_PIXELS", 48000}};
  r.cycles = {{"CLEAR", {{"BUSY", 258}}},
              {"DRAW", {{"BUSY", 2000}, {"HAZARD", 100}}},
              {"FILL", {{"BUSY", 4000}}},
              {"QUERY", {{"BUSY", 1000000}, {"HAZARD", 5}}},
              {"READ", {{"BUSY", 65536}}}};
  return r;
}

RunRecord topology_record() {
  RunRecord r = sample_record();
  r.technique = "voxel-topology";
  r.plane.reset();
  r.hardware.en_vpu_topology = true;
  r.hardware.en_vpu_offset = false;
  r.topology = TopologyRecord{512, 1.0, 40000, 118, 49, 1000, 2000};
  r.events = {{"QUADS_PUT", 90000},          {"NODES_LINKED", 360000},  {"TOPOLOGY_RESOLVED", 217000},
              {"TOPOLOGY_UNCERTAIN", 50000}, {"NODES_VISITED", 260000}, {"QUADS_TESTED", 250000}};
  r.cycles = {{"PROJECT", {{"BUSY", 540000}}}, {"RESOLVE", {{"BUSY", 260000}}}};
  return r;
}

RunRecord lights_record() {
  RunRecord r = sample_record();
  LightRecord& sun = r.lights.front();
  sun.in_shadow = 30000;
  sun.errors = r.errors;
  sun.views = {{"directional", 217000, 217000, {}, {}, r.plane, {}, {}, {}}};
  LightRecord& spot = r.lights.emplace_back();
  spot.light = SpotLight{Vec3(0, 4, 1), Vec3(0, -1, 0), 20};
  spot.in_shadow = 41000;
  spot.not_reached = 15000;
  spot.errors = r.errors;
  const std::map<std::string, std::uint64_t> events{{"VOXELS_PROJECTED", 90000}, {"PROJECT_BEHIND", 1000}};
  spot.views = {{"spot", 90000, 80000, events, {}, PlaneRecord{128, 4000, 1.5, 1}, {}, {}, {}}};
  r.plane->views = 2;
  return r;
}

RunRecord system_record() {
  RunRecord r = sample_record();
  r.engine = "system";
  SystemRecord& system = r.system.emplace();
  system.hardware = "core";
  system.statistics.cycles = 500000;
  system.statistics.cpu.instructions = 4200;
  system.statistics.cpu.cycles = 500100;
  system.statistics.cpu.cycles_asleep = 495000;
  system.statistics.dram = {7000, 3500, 4000000, 10000, 8, 492, 500000};
  system.statistics.bus = {{"dram", 7000, 3500, 4000000}, {"hardware", 20, 30, 200}};
  system.firmware_bytes = 4700;
  system.log = "firmware <0>\nsecond line\n";
  system.cache = {{"CACHE_PLANE_HITS", 4000}, {"CACHE_PLANE_MISSES", 100}};
  system.jobs.resize(2);
  system.jobs[0].instructions = 500;
  system.jobs[1].instructions = 600;
  return r;
}

RunRecord golden_record() {
  RunRecord r = sample_record();
  r.engine = "golden";
  r.compare = {};
  r.cycles.clear();
  return r;
}

RunRecord failing_record() {
  RunRecord r = sample_record();
  r.compare.differing = 3;
  r.compare.text =
      "first difference: result word 41\n  command   9  RESOLVE_VOXELS\n  cycle     4711\n3 differ <here>\n";
  r.compare.first = {{"result_index", 41},
                     {"cycle", 4711},
                     {"command_index", 9},
                     {"command", "RESOLVE_VOXELS count=65535"},
                     {"item_index", 41},
                     {"item", "position (1, 2, 3)"},
                     {"expected", {{"word", "1140000000000000"}, {"fields", "VOXEL_STATE lit"}}},
                     {"rtl", {{"word", "1180000000000000"}, {"fields", "VOXEL_STATE shadow"}}}};
  return r;
}

}  // namespace gnomon::report
