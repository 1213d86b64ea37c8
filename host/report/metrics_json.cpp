// SPDX-License-Identifier: Apache-2.0
// metrics.json: every figure of a run, with the whole configuration.
#include "host/report/metrics_json.hpp"

#include <algorithm>
#include <gnomon/golden/formats.hpp>
#include <numeric>

#include "host/report/metrics_parts.hpp"
#include "host/report/numbers.hpp"

namespace gnomon::report {
namespace {

Json parameters_json(const RunRecord& record) {
  Json all = Json::object();
  for (const ParameterValue& p : record.parameters) {
    all[p.key] = {{"value", p.value}, {"unit", p.unit}, {"origin", p.origin}, {"meaning", p.help}};
  }
  return all;
}

Json hardware_json(const golden::HardwareConfig& c) {
  Json json = {{"VOXEL_BITS", c.voxel_bits},       {"VOXEL_FRAC_BITS", c.voxel_frac_bits},
               {"NORMAL_BITS", c.normal_bits},     {"MATRIX_FRAC_BITS", c.matrix_frac_bits},
               {"DEPTH_BITS", c.depth_bits},       {"PLANE_LOG2", c.plane_log2},
               {"EN_VPU_OFFSET", c.en_vpu_offset}, {"EN_SLB", c.en_slb}};
  json["EN_PERSPECTIVE"] = c.en_perspective;
  json["EN_VPU_TOPOLOGY"] = c.en_vpu_topology;
  if (c.en_vpu_topology) {
    json["SUB_BITS"] = c.sub_bits;
    json["SPAN_LOG2"] = c.span_log2;
    json["NODES_LOG2"] = c.nodes_log2;
    json["QUADS_LOG2"] = c.quads_log2;
  }
  json["EN_FRAME_BUFFER"] = c.en_frame_buffer;
  if (c.en_frame_buffer) json["FRAME_LAYERS_LOG2"] = c.frame_layers_log2;
  if (!c.en_slb) return json;
  json["SLB_PLANE_LOG2"] = c.slb_plane_log2;
  json["FRAC_BITS"] = c.frac_bits;
  json["SLOPE_BITS"] = c.slope_bits;
  json["FRAGS_PER_PIXEL"] = c.frags_per_pixel;
  json["SUBPIXEL_BITS"] = c.subpixel_bits;
  json["QUERY_BITS"] = c.query_bits;
  json["SLB_ROUNDING"] = c.slb_rounding == golden::slb::Rounding::Better ? "better" : "published";
  return json;
}

/// The formats of docs/number-formats.md in this configuration.
Json formats_json(const golden::HardwareConfig& config) {
  Json all = Json::array();
  for (const golden::ValueFormat& f : golden::value_formats(config)) {
    all.push_back(
        {{"name", f.name}, {"width", f.width}, {"signed", f.is_signed}, {"frac_bits", f.frac_bits}});
  }
  return all;
}

Json registers_json(const RunRecord& record) {
  Json all = Json::object();
  for (const RegisterRecord& r : record.registers) {
    all[r.name] = {
        {"value", r.value}, {"width", r.width}, {"signed", r.is_signed}, {"frac_bits", r.frac_bits}};
  }
  return all;
}

Json grid_json(const voxel::Grid& grid) {
  return {{"res", grid.res},
          {"origin", vector_json(grid.origin)},
          {"voxel_size", grid.voxel_size},
          {"adjacency", static_cast<int>(grid.adjacency)}};
}

Json statistics_json(const scene::MeshStatistics& s) {
  return {{"vertices", s.vertices},
          {"unused_vertices", s.unused_vertices},
          {"faces", s.faces},
          {"triangles", s.triangles},
          {"quads", s.quads},
          {"ngons", s.ngons},
          {"largest_face", s.largest_face},
          {"hole_faces", s.hole_faces},
          {"degenerate_faces", s.degenerate_faces},
          {"edges", s.edges},
          {"boundary_edges", s.boundary_edges},
          {"non_manifold_edges", s.non_manifold_edges},
          {"inconsistent_edges", s.inconsistent_edges},
          {"unorientable_edges", s.unorientable_edges},
          {"reversed_faces", s.reversed_faces},
          {"extraordinary_vertices", s.extraordinary_vertices},
          {"largest_valence", s.largest_valence},
          {"creases", s.creases},
          {"corners", s.corners}};
}

Json objects_json(const RunRecord& record) {
  Json all = Json::array();
  for (const ObjectRecord& object : record.objects) {
    all.push_back({{"name", object.name},
                   {"ground", object.ground},
                   {"two_sided", object.two_sided},
                   {"casts", object.casts},
                   {"receives", object.receives},
                   {"cage", statistics_json(object.statistics)}});
  }
  return all;
}

Json voxels_json(const RunRecord& record) {
  const voxel::VoxelStatistics& s = record.voxel_statistics;
  const std::uint64_t uncertain = event(record.events, "RESOLVED_UNCERTAIN");
  const std::uint64_t shadow = record.voxels_in_shadow;
  const std::uint64_t answers = record.voxels * record.lights.size();
  const std::uint64_t resolved = event(record.events, "VOXELS_RESOLVED");
  return {{"count", record.voxels},
          {"subpatches", s.subpatches},
          {"evaluations", s.evaluations},
          {"evaluations_per_voxel", ratio(s.evaluations, record.voxels)},
          {"floor_hits", s.floor_hits},
          {"zero_normals", s.zero_normals},
          {"seconds", s.seconds},
          {"mvoxels_per_second", ratio(static_cast<double>(record.voxels) * 1e-6, s.seconds)},
          {"shadow", shadow},
          {"shadow_share", ratio(shadow, answers)},
          {"facing_away", event(record.events, "RESOLVED_FACING_AWAY")},
          {"uncertain", uncertain},
          {"uncertain_share", ratio(uncertain, resolved > 0 ? resolved : answers)},
          {"offset_empty", event(record.events, "RESOLVED_OFFSET_EMPTY")}};
}

Json memory_json(const RunRecord& record) {
  const std::uint64_t entries = record.plane ? std::uint64_t{record.plane->side} * record.plane->side : 0;
  const SlbRecord slb = record.slb.value_or(SlbRecord{});
  const std::uint64_t pixels = std::uint64_t{slb.side} * slb.side;
  const std::uint64_t lists = record.topology ? topology_bits(*record.topology) : 0;
  const std::uint64_t scratch = pixels * slb.pixel_scratch_bits + slb.side * slb.row_bits;
  const std::uint64_t frame = frame_buffer_bits(record.hardware);
  const std::uint64_t software = record.software ? record.software->memory_bits : 0;
  return {{"plane_entries", entries},
          {"plane_entry_bits", kPlaneEntryBits},
          {"plane_bits", entries * kPlaneEntryBits},
          {"plane_depth_bits", entries * static_cast<std::uint64_t>(record.hardware.depth_bits)},
          {"slb_entry_bits", slb.entry_bits},
          {"slb_plane_bits", pixels * slb.entry_bits},
          {"slb_scratch_bits", scratch},
          {"topology_bits", lists},
          {"software_bits", software},
          {"hardware_bits",
           lists + entries * kPlaneEntryBits + pixels * slb.entry_bits + scratch + frame + software},
          {"frame_buffer_bits", frame},
          {"command_stream_bits", 64 * record.command_words},
          {"result_stream_bits", 64 * record.result_words}};
}

Json compare_json(const CompareRecord& compare) {
  return {{"compared", compare.compared},
          {"words", compare.words},
          {"differing", compare.differing},
          {"other_faults", compare.other_faults},
          {"failed", compare.failed()},
          {"partial", compare.partial.empty() ? Json() : Json(compare.partial)},
          {"verdict", verdict(compare)},
          {"first_difference", Json(compare.first)},
          {"text", compare.text}};
}

Json picture_json(const PictureRecord& picture) {
  return {{"width", picture.width},
          {"height", picture.height},
          {"mask", counts_json(picture.mask)},
          {"intersection_over_union", picture.intersection_over_union},
          {"rmse", picture.rmse}};
}

std::uint64_t total(const PassCycles& pass) {
  return std::accumulate(pass.causes.begin(), pass.causes.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& cause) { return sum + cause.second; });
}

/// The stage's times; zeros where it did not run.
StageTime stage_of(const RunRecord& record, std::string_view stage) {
  const auto found = std::ranges::find(record.stages, stage, &StageTime::name);
  return found == record.stages.end() ? StageTime{} : *found;
}

Json cycles_json(const RunRecord& record) {
  if (record.cycles.empty()) return nullptr;
  Json passes = Json::object();
  Json per_voxel = Json::object();
  Json rates = {
      {"cycles_per_crossing", nullptr}, {"cycles_per_query", nullptr}, {"fill_pixels_per_cycle", nullptr}};
  Json rates_of_lists = {{"cycles_per_node", nullptr}, {"cycles_per_node_visited", nullptr}};
  std::uint64_t sum = 0;
  for (const PassCycles& pass : record.cycles) {
    const std::uint64_t cycles = total(pass);
    sum += cycles;
    passes[pass.pass] = {{"total", cycles}, {"causes", pass.causes}};
    if (pass.pass == "PROJECT")
      per_voxel["project"] = ratio(cycles, event(record.events, "VOXELS_PROJECTED"));
    if (pass.pass == "PROJECT")
      rates_of_lists["cycles_per_node"] = ratio(cycles, event(record.events, "NODES_LINKED"));
    if (pass.pass == "RESOLVE")
      rates_of_lists["cycles_per_node_visited"] = ratio(cycles, event(record.events, "NODES_VISITED"));
    if (pass.pass == "RESOLVE") per_voxel["resolve"] = ratio(cycles, event(record.events, "VOXELS_RESOLVED"));
    if (pass.pass == "DRAW")
      rates["cycles_per_crossing"] = ratio(cycles, event(record.events, "SLB_CROSSINGS"));
    if (pass.pass == "QUERY") rates["cycles_per_query"] = ratio(cycles, event(record.events, "SLB_QUERIES"));
    if (pass.pass == "FILL")
      rates["fill_pixels_per_cycle"] = ratio(event(record.events, "SLB_FILL_PIXELS"), cycles);
  }
  return {{"total", sum},
          {"by_pass", passes},
          {"per_voxel", per_voxel},
          {"slb", rates},
          {"topology", rates_of_lists}};
}

/// By the cycle model, and how far from what was measured.
Json predicted_json(const RunRecord& record) {
  if (record.predicted_cycles.empty()) return nullptr;
  Json passes = Json::object();
  std::uint64_t sum = 0;
  for (const auto& [name, cycles] : record.predicted_cycles) {  // "cycles.<PASS>.<CAUSE>"
    const std::size_t pass = name.find('.') + 1, cause = name.find('.', pass) + 1;
    Json& row = passes[name.substr(pass, cause - pass - 1)];
    if (row.is_null()) row = {{"total", 0}, {"causes", Json::object()}};
    row["total"] = row["total"].get<std::uint64_t>() + cycles;
    row["causes"][name.substr(cause)] = cycles;
    sum += cycles;
  }
  Json off = nullptr;
  for (const PassCycles& pass : record.cycles) {
    if (pass.pass == "IDLE" || !passes.contains(pass.pass)) continue;
    const auto predicted = passes[pass.pass]["total"].get<std::uint64_t>(), measured = total(pass);
    const std::uint64_t distance = predicted > measured ? predicted - measured : measured - predicted;
    off = (off.is_null() ? 0 : off.get<std::uint64_t>()) + distance;
  }
  return {{"total", sum}, {"by_pass", passes}, {"off", off}};
}

Json run_time_json(const RunRecord& record, const Json& cycles) {
  Json time = {{"clock_mhz", record.clock_mhz},
               {"cycles", nullptr},
               {"seconds_at_clock", nullptr},
               {"simulation_mcycles_per_second", nullptr},
               {"simulation_mcycles_per_cpu_second", nullptr}};
  if (!cycles.is_null()) {
    const auto count = cycles["total"].get<double>();
    std::uint64_t shadows = cycles["total"].get<std::uint64_t>();
    if (cycles["by_pass"].contains("READ"))
      shadows -= cycles["by_pass"]["READ"]["total"].get<std::uint64_t>();
    time["cycles"] = shadows;
    time["seconds_at_clock"] = static_cast<double>(shadows) / (record.clock_mhz * 1e6);
    const StageTime simulation = stage_of(record, engine_stage(record.engine));
    time["simulation_mcycles_per_second"] = ratio(count * 1e-6, simulation.wall_seconds);
    time["simulation_mcycles_per_cpu_second"] = ratio(count * 1e-6, simulation.user_seconds);
  }
  double wall = 0;
  for (const StageTime& stage : record.stages) wall += stage.wall_seconds;
  time["host_seconds"] = wall;
  time["host_peak_memory_bytes"] = record.peak_memory_bytes;
  return time;
}

Json stages_json(const RunRecord& record) {
  Json all = Json::array();
  for (const StageTime& s : record.stages) {
    all.push_back({{"name", s.name}, {"wall_seconds", s.wall_seconds}, {"user_seconds", s.user_seconds}});
  }
  return all;
}

/// null without a moving camera.
Json frames_json(const std::optional<FramesRecord>& frames) {
  if (!frames) return nullptr;
  const auto sum = [](const std::map<std::string, std::uint64_t>& events) {
    return std::accumulate(events.begin(), events.end(), std::uint64_t{0},
                           [](std::uint64_t total, const auto& event) { return total + event.second; });
  };
  const double count = std::max(1.0, static_cast<double>(frames->count));
  return {{"count", frames->count},
          {"seconds_per_frame", frames->seconds / count},
          {"user_seconds_per_frame", frames->user_seconds / count},
          {"command_words", frames->command_words},
          {"result_words", frames->result_words},
          {"questions", Json(frames->questions)},
          {"shadow_work", sum(frames->shadow_work)},
          {"shadow_work_events", Json(frames->shadow_work)}};
}

}  // namespace

std::string verdict(const CompareRecord& compare) {
  if (compare.software) return "nothing to compare: a technique in software";
  if (!compare.compared) return "nothing compared: the golden engine ran alone";
  std::string text =
      with_commas(compare.words) + " words compared, " + with_commas(compare.differing) + " differ";
  if (compare.words == 0) text += ": nothing is verified";
  if (!compare.partial.empty()) text = "partial, " + compare.partial + ": " + text;
  if (compare.other_faults != 0) text += "; " + with_commas(compare.other_faults) + " other faults";
  return text;
}

Json metrics_json(const RunRecord& record) {
  const Json cycles = cycles_json(record);
  Json versions = Json::object();
  for (const auto& [tool, version] : record.versions) versions[tool] = version;
  return {{"schema", kMetricsSchema},
          {"scene", {{"name", record.scene_name}, {"source", record.scene_source}}},
          {"command", {{"line", shell_line(record.command_line)}, {"arguments", record.command_line}}},
          {"started", record.started},
          {"versions", versions},
          {"engine", record.engine},
          {"technique", record.technique},
          {"techniques", Json::array()},
          {"seed", record.seed},
          {"parameters", parameters_json(record)},
          {"hardware", hardware_json(record.hardware)},
          {"formats", formats_json(record.hardware)},
          {"registers", registers_json(record)},
          {"grid", grid_json(record.grid)},
          {"lights", lights_json(record)},
          {"objects", objects_json(record)},
          {"warnings", record.warnings},
          {"compare", compare_json(record.compare)},
          {"errors", errors_json(record.errors)},
          {"exact_reference", exact_json(record.exact)},
          {"picture", picture_json(record.picture)},
          {"frames", frames_json(record.frames)},
          {"cycles", cycles},
          {"cycles_predicted", predicted_json(record)},
          {"run_time", run_time_json(record, cycles)},
          {"system", system_json(record.system)},
          {"memory", memory_json(record)},
          {"plane", plane_json(record.plane, record.events)},
          {"topology", topology_json(record.topology, record.events)},
          {"slb", slb_json(record.slb, record.events)},
          {"software", software_json(record.software)},
          {"voxels", voxels_json(record)},
          {"events", record.events},
          {"stages", stages_json(record)}};
}

Json metrics_json(std::span<const RunRecord> records) {
  Json all = metrics_json(records.front());
  if (records.size() < 2) return all;
  for (const RunRecord& record : records) {
    const Json one = metrics_json(record);
    Json row = Json::object();
    for (const char* key :
         {"technique", "hardware", "registers",        "lights",   "compare", "errors", "picture",
          "frames",    "cycles",   "cycles_predicted", "run_time", "system",  "memory", "plane",
          "topology",  "slb",      "software",         "voxels",   "events",  "stages"})
      row[key] = one.at(key);
    all["techniques"].push_back(std::move(row));
  }
  return all;
}

}  // namespace gnomon::report
