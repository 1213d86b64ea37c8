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
  for (const auto& [key, name] : keys) rows.push_back(row(name, count(object.at(key))));
  return rows;
}

Json object_row(const Json& object) {
  const Json& cage = object.at("cage");
  // A ground is open by nature.
  const auto flag = [&](const char* key) {
    return !object.at("ground").get<bool>() && cage.at(key).get<std::uint64_t>() > 0;
  };
  return {{"name", object.at("name")},
          {"role", object.at("ground").get<bool>() ? "ground" : "model"},
          {"sides", object.at("two_sided").get<bool>() ? "open" : "closed"},
          {"vertices", count(cage.at("vertices"))},
          {"faces", count(cage.at("faces"))},
          {"kinds", fmt::format("{} / {} / {}", count(cage.at("triangles")), count(cage.at("quads")),
                                count(cage.at("ngons")))},
          {"boundary", count(cage.at("boundary_edges"))},
          {"boundary_flag", flag("boundary_edges")},
          {"non_manifold", count(cage.at("non_manifold_edges"))},
          {"non_manifold_flag", flag("non_manifold_edges")},
          {"inconsistent", count(cage.at("inconsistent_edges"))},
          {"inconsistent_flag", flag("inconsistent_edges")},
          {"degenerate", count(cage.at("degenerate_faces"))},
          {"degenerate_flag", flag("degenerate_faces")},
          {"extraordinary", count(cage.at("extraordinary_vertices"))},
          {"valence", count(cage.at("largest_valence"))},
          {"sharp", fmt::format("{} / {}", count(cage.at("creases")), count(cage.at("corners")))}};
}

Json voxel_rows(const Json& m) {
  const Json& v = m.at("voxels");
  Json rows = table_of(
      v, {{"count", "voxels"}, {"subpatches", "subpatches"}, {"evaluations", "limit-surface evaluations"}});
  rows.push_back(row("evaluations a voxel", number(v.at("evaluations_per_voxel"), 3)));
  rows.push_back(row("voxelization", fmt::format("{}, {} Mvoxels/s", seconds(v.at("seconds")),
                                                 number(v.at("mvoxels_per_second"), 2))));
  for (const Json& r :
       table_of(v, {{"floor_hits", "recursion floor reached"}, {"zero_normals", "normals nudged"}}))
    rows.push_back(r);
  if (m.at("plane").is_null()) return rows;
  rows.push_back(
      row("in shadow", fmt::format("{} ({})", count(v.at("shadow")), share(v.at("shadow_share")))));
  rows.push_back(row("facing away", count(v.at("facing_away"))));
  rows.push_back(
      row("uncertain", fmt::format("{} ({})", count(v.at("uncertain")), share(v.at("uncertain_share")))));
  rows.push_back(row("uncertain, offset entry empty", count(v.at("offset_empty"))));
  return rows;
}

Json topology_rows(const Json& m) {
  const Json& t = m.at("topology");
  Json rows = Json::array();
  rows.push_back(row("side", count(t.at("side")) + " entries"));
  rows.push_back(row("pitch", fmt::format("{:g} voxels an entry", t.at("pitch").get<double>())));
  rows.push_back(row("quads, nodes", count(t.at("quads")) + ", " + count(t.at("nodes"))));
  rows.push_back(row("nodes that did not fit", count(t.at("nodes_dropped"))));
  rows.push_back(row("list length, mean and longest",
                     number(t.at("mean_list"), 2) + ", " + count(t.at("longest_list"))));
  rows.push_back(row("facing away", count(t.at("facing_away"))));
  rows.push_back(
      row("uncertain", fmt::format("{} ({})", count(t.at("uncertain")), share(t.at("uncertain_share")))));
  rows.push_back(row(
      "an uncertain voxel: nodes visited, quads tested",
      number(t.at("nodes_visited_per_uncertain"), 2) + ", " + number(t.at("quads_tested_per_uncertain"), 2)));
  rows.push_back(
      row("hits; answered by the nearest depth", count(t.at("hits")) + "; " + count(t.at("fallbacks"))));
  rows.push_back(
      row("memory: heads, nodes, quads", bits(m.at("memory").at("topology_bits").get<std::uint64_t>())));
  return rows;
}

Json slb_rows(const Json& m) {
  const Json& s = m.at("slb");
  const Json& memory = m.at("memory");
  Json rows = Json::array();
  rows.push_back(row("side", count(s.at("side")) + " pixels"));
  rows.push_back(row("pitch", fmt::format("{:.4g} voxels a pixel", s.at("pitch").get<double>())));
  rows.push_back(row("loops, vertices", count(s.at("loops")) + ", " + count(s.at("vertices"))));
  rows.push_back(row("pixel borders crossed", count(s.at("crossings"))));
  for (std::size_t k = 1; k < 5; ++k) {
    const Json& pixels = s.at("pixels_by_fragments").at(k);
    if (pixels != 0)
      rows.push_back(row(fmt::format("pixels with {} fragment{}", k, k > 1 ? "s" : ""), count(pixels)));
  }
  rows.push_back(row("pixels wholly covered", count(s.at("full_pixels"))));
  rows.push_back(row("pixels where something did not fit", count(s.at("overflow_pixels"))));
  rows.push_back(row("chains reduced, dropped; groups evicted",
                     fmt::format("{}, {}; {}", count(s.at("chains_reduced")), count(s.at("chains_dropped")),
                                 count(s.at("groups_evicted")))));
  rows.push_back(row("queries", count(s.at("queries"))));
  rows.push_back(
      row("queries of a pixel where something did not fit",
          fmt::format("{} ({})", count(s.at("queries_overflow")), share(s.at("queries_overflow_share")))));
  rows.push_back(row("memory, entries", fmt::format("{} ({} bit a pixel)",
                                                    bits(memory.at("slb_plane_bits").get<std::uint64_t>()),
                                                    memory.at("slb_entry_bits").dump())));
  rows.push_back(row("memory, scratch", bits(memory.at("slb_scratch_bits").get<std::uint64_t>())));
  return rows;
}

Json plane_rows(const Json& m) {
  const Json& p = m.at("plane");
  Json rows = Json::array();
  rows.push_back(row("side", count(p.at("side")) + " entries"));
  rows.push_back(row("pitch", fmt::format("{:g} voxels an entry", p.at("pitch").get<double>())));
  rows.push_back(row("entries hit", fmt::format("{} of {} ({})", count(p.at("entries_hit")),
                                                count(p.at("entries")), share(p.at("share_hit")))));
  rows.push_back(row("voxels on an entry hit", number(p.at("voxels_per_entry_hit"), 3)));
  rows.push_back(row("voxels off the plane", count(p.at("off_plane"))));
  rows.push_back(row("depths saturated", count(p.at("saturated"))));
  rows.push_back(row("memory, as built", bits(m.at("memory").at("plane_bits").get<std::uint64_t>())));
  rows.push_back(
      row("memory, depth codes alone", bits(m.at("memory").at("plane_depth_bits").get<std::uint64_t>())));
  rows.push_back(row("command stream", bits(m.at("memory").at("command_stream_bits").get<std::uint64_t>())));
  return rows;
}

}  // namespace

Json configuration_section(const Json& m) {
  Json view;
  view["parameters"] = Json::array();
  for (const auto& [key, p] : m.at("parameters").items()) {
    view["parameters"].push_back({{"key", key},
                                  {"value", plain(p.at("value"))},
                                  {"unit", p.at("unit")},
                                  {"origin", p.at("origin")},
                                  {"chosen", p.at("origin") != "default"},
                                  {"meaning", p.at("meaning")}});
  }
  view["hardware"] = Json::array();
  for (const auto& [name, value] : m.at("hardware").items())
    view["hardware"].push_back(row(name, value.dump()));
  view["formats"] = Json::array();
  for (const Json& f : m.at("formats")) {
    view["formats"].push_back({{"name", f.at("name")},
                               {"width", f.at("width").dump()},
                               {"signed", f.at("signed").get<bool>() ? "signed" : "unsigned"},
                               {"frac", f.at("frac_bits").dump()}});
  }
  view["registers"] = Json::array();
  for (const auto& [name, r] : m.at("registers").items()) {
    const double real = std::ldexp(r.at("value").get<double>(), -r.at("frac_bits").get<int>());
    view["registers"].push_back({{"name", name},
                                 {"value", r.at("value").dump()},
                                 {"width", r.at("width").dump()},
                                 {"frac", r.at("frac_bits").dump()},
                                 {"signed", r.at("signed").get<bool>() ? "signed" : "unsigned"},
                                 {"real", fmt::format("{:.6g}", real)}});
  }
  view["versions"] = Json::array();
  for (const auto& [tool, version] : m.at("versions").items()) view["versions"].push_back(row(tool, version));
  view["seed"] = m.at("seed").dump();
  return view;
}

Json model_section(const Json& m) {
  Json view;
  view["objects"] = Json::array();
  for (const Json& object : m.at("objects")) view["objects"].push_back(object_row(object));
  view["warnings"] = Json::array();
  for (const Json& warning : m.at("warnings")) view["warnings"].push_back({{"text", warning}});
  view["has_warnings"] = !m.at("warnings").empty();
  const Json& grid = m.at("grid");
  view["grid_line"] = fmt::format(
      "{0} × {0} × {0} voxels of {1:.6g} world units; low corner ({2:.6g}, {3:.6g}, {4:.6g})",
      grid.at("res").dump(), grid.at("voxel_size").get<double>(), grid.at("origin").at(0).get<double>(),
      grid.at("origin").at(1).get<double>(), grid.at("origin").at(2).get<double>());
  view["voxel_rows"] = voxel_rows(m);
  view["plane"] = view["slb"] = view["topology"] = false;
  if (!m.at("topology").is_null()) view["topology"] = {{"rows", topology_rows(m)}};
  if (!m.at("plane").is_null()) view["plane"] = {{"rows", plane_rows(m)}};
  if (!m.at("slb").is_null()) view["slb"] = {{"rows", slb_rows(m)}};
  return view;
}

}  // namespace gnomon::report
