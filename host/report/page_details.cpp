// SPDX-License-Identifier: Apache-2.0
// What was run: parameters, hardware, formats, models, voxels, plane.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "host/report/numbers.hpp"
#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

Json table_of(const Json& object, const std::vector<std::pair<const char*, const char*>>& keys) {
  Json rows = Json::array();
  for (const auto& [key, name] : keys) rows.push_back(row(name, count(object[key])));
  return rows;
}

Json object_row(const Json& object) {
  const Json& cage = object["cage"];
  const auto flag = [&](const char* key) { return cage[key].get<std::uint64_t>() > 0; };
  return {{"name", object["name"]},
          {"role", object["ground"].get<bool>() ? "ground" : "model"},
          {"sides", object["two_sided"].get<bool>() ? "open, two-sided" : "closed"},
          {"vertices", count(cage["vertices"])},
          {"faces", count(cage["faces"])},
          {"kinds",
           fmt::format("{} / {} / {}", count(cage["triangles"]), count(cage["quads"]), count(cage["ngons"]))},
          {"boundary", count(cage["boundary_edges"])},
          {"boundary_flag", flag("boundary_edges")},
          {"non_manifold", count(cage["non_manifold_edges"])},
          {"non_manifold_flag", flag("non_manifold_edges")},
          {"inconsistent", count(cage["inconsistent_edges"])},
          {"inconsistent_flag", flag("inconsistent_edges")},
          {"degenerate", count(cage["degenerate_faces"])},
          {"degenerate_flag", flag("degenerate_faces")},
          {"unused", count(cage["unused_vertices"])},
          {"unused_flag", flag("unused_vertices")},
          {"extraordinary", count(cage["extraordinary_vertices"])},
          {"valence", count(cage["largest_valence"])},
          {"sharp", fmt::format("{} / {}", count(cage["creases"]), count(cage["corners"]))}};
}

Json voxel_rows(const Json& m) {
  const Json& v = m["voxels"];
  Json rows = table_of(
      v, {{"count", "voxels"}, {"subpatches", "subpatches"}, {"evaluations", "limit-surface evaluations"}});
  rows.push_back(row("evaluations a voxel", number(v["evaluations_per_voxel"], 3)));
  rows.push_back(row("voxelization", fmt::format("{}, {} Mvoxels/s", seconds(v["seconds"]),
                                                 number(v["mvoxels_per_second"], 2))));
  for (const Json& r :
       table_of(v, {{"floor_hits", "recursion floor reached"}, {"zero_normals", "normals nudged"}}))
    rows.push_back(r);
  rows.push_back(row("in shadow", fmt::format("{} ({})", count(v["shadow"]), share(v["shadow_share"]))));
  rows.push_back(row("facing away", count(v["facing_away"])));
  rows.push_back(
      row("uncertain", fmt::format("{} ({})", count(v["uncertain"]), share(v["uncertain_share"]))));
  rows.push_back(row("uncertain, offset entry empty", count(v["offset_empty"])));
  return rows;
}

Json plane_rows(const Json& m) {
  const Json& p = m["plane"];
  Json rows = Json::array();
  rows.push_back(row("side", count(p["side"]) + " entries"));
  rows.push_back(row("pitch", fmt::format("{:g} voxels an entry", p["pitch"].get<double>())));
  rows.push_back(row("entries hit", fmt::format("{} of {} ({})", count(p["entries_hit"]), count(p["entries"]),
                                                share(p["share_hit"]))));
  rows.push_back(row("voxels on an entry hit", number(p["voxels_per_entry_hit"], 3)));
  rows.push_back(row("voxels off the plane", count(p["off_plane"])));
  rows.push_back(row("depths saturated", count(p["saturated"])));
  rows.push_back(row("memory, as built", bits(m["memory"]["plane_bits"].get<std::uint64_t>())));
  rows.push_back(
      row("memory, depth codes alone", bits(m["memory"]["plane_depth_bits"].get<std::uint64_t>())));
  rows.push_back(row("command stream", bits(m["memory"]["command_stream_bits"].get<std::uint64_t>())));
  return rows;
}

}  // namespace

Json configuration_section(const Json& m) {
  Json view;
  view["parameters"] = Json::array();
  for (const auto& [key, p] : m["parameters"].items()) {
    view["parameters"].push_back({{"key", key},
                                  {"value", plain(p["value"])},
                                  {"unit", p["unit"]},
                                  {"origin", p["origin"]},
                                  {"chosen", p["origin"] != "default"},
                                  {"meaning", p["meaning"]}});
  }
  view["hardware"] = Json::array();
  for (const auto& [name, value] : m["hardware"].items()) view["hardware"].push_back(row(name, value.dump()));
  view["formats"] = Json::array();
  for (const Json& f : m["formats"]) {
    view["formats"].push_back({{"name", f["name"]},
                               {"width", f["width"].dump()},
                               {"signed", f["signed"].get<bool>() ? "signed" : "unsigned"},
                               {"frac", f["frac_bits"].dump()}});
  }
  view["registers"] = Json::array();
  for (const auto& [name, r] : m["registers"].items()) {
    const double real = std::ldexp(r["value"].get<double>(), -r["frac_bits"].get<int>());
    view["registers"].push_back({{"name", name},
                                 {"value", r["value"].dump()},
                                 {"width", r["width"].dump()},
                                 {"frac", r["frac_bits"].dump()},
                                 {"signed", r["signed"].get<bool>() ? "signed" : "unsigned"},
                                 {"real", fmt::format("{:.6g}", real)}});
  }
  view["versions"] = Json::array();
  for (const auto& [tool, version] : m["versions"].items()) view["versions"].push_back(row(tool, version));
  view["seed"] = m["seed"].dump();
  return view;
}

Json model_section(const Json& m) {
  Json view;
  view["objects"] = Json::array();
  for (const Json& object : m["objects"]) view["objects"].push_back(object_row(object));
  view["warnings"] = Json::array();
  for (const Json& warning : m["warnings"]) view["warnings"].push_back({{"text", warning}});
  view["has_warnings"] = !m["warnings"].empty();
  const Json& grid = m["grid"];
  view["grid_line"] =
      fmt::format("{0} × {0} × {0} voxels of {1:.6g} world units; low corner ({2:.6g}, {3:.6g}, {4:.6g})",
                  grid["res"].dump(), grid["voxel_size"].get<double>(), grid["origin"][0].get<double>(),
                  grid["origin"][1].get<double>(), grid["origin"][2].get<double>());
  view["voxel_rows"] = voxel_rows(m);
  view["plane_rows"] = plane_rows(m);
  return view;
}

}  // namespace gnomon::report
