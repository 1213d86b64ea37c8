// SPDX-License-Identifier: Apache-2.0
// The report's first screen: verdict and key figures.
#include <fmt/format.h>

#include <string>
#include <utility>

#include "host/report/numbers.hpp"
#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

Json tile(const char* name, std::string value, std::string note) {
  return {{"name", name}, {"value", std::move(value)}, {"note", std::move(note)}};
}

Json verdict_view(const Json& compare) {
  const bool compared = compare.at("compared"), failed = compare.at("failed");
  Json view = {{"verdict_good", compared && !failed},
               {"verdict_bad", failed},
               {"verdict_none", !compared},
               {"verdict", compare.at("verdict")},
               {"difference_text", compare.at("text")},
               {"first", false}};
  if (const Json& first = compare.at("first_difference"); !first.is_null()) {
    const auto word = [&](const char* engine) {
      return first.at(engine).is_null() ? std::string("no such word")
                                        : fmt::format("{} {}", plain(first.at(engine).at("word")),
                                                      plain(first.at(engine).at("fields")));
    };
    view["first"] = {
        {"word", count(first.at("result_index"))},
        {"command", first.contains("command") ? plain(first.at("command")) : kNone},
        {"command_index", first.contains("command_index") ? count(first.at("command_index")) : kNone},
        {"cycle", first.contains("cycle") ? count(first.at("cycle")) : kNone},
        {"item", first.contains("item") ? plain(first.at("item")) : kNone},
        {"expected", word("expected")},
        {"actual", word("rtl")}};
  }
  return view;
}

/// Cycles for each item of the units that the technique uses.
void add_rates(const Json& m, Json& tiles) {
  if (!m.at("plane").is_null()) {
    const Json& per_voxel = m.at("cycles").at("per_voxel");
    tiles.push_back(tile("cycles a voxel",
                         number(per_voxel.at("project"), 3) + " + " + number(per_voxel.at("resolve"), 3),
                         "project + resolve"));
  }
  if (!m.at("topology").is_null()) {
    const Json& rates = m.at("cycles").at("topology");
    tiles.push_back(
        tile("cycles a node",
             number(rates.at("cycles_per_node"), 3) + " + " + number(rates.at("cycles_per_node_visited"), 3),
             "linked + visited"));
  }
  if (m.at("slb").is_null()) return;
  const Json& rates = m.at("cycles").at("slb");
  tiles.push_back(
      tile("cycles a crossing, a query",
           number(rates.at("cycles_per_crossing"), 3) + ", " + number(rates.at("cycles_per_query"), 3),
           fmt::format("fill: {} pixels a cycle", number(rates.at("fill_pixels_per_cycle"), 1))));
}

std::string memory_note(const Json& m) {
  const Json& memory = m.at("memory");
  std::string note;
  if (const Json& s = m.at("software"); !s.is_null())
    return s.at("side") == 0
               ? count(s.at("triangles")) + " triangles and their hierarchy"
               : fmt::format("{}² texels × {} bit", s.at("side").dump(), s.at("texel_bits").dump());
  if (!m.at("plane").is_null())
    note = fmt::format("{} entries × {} bit", count(memory.at("plane_entries")),
                       memory.at("plane_entry_bits").dump());
  if (!m.at("topology").is_null())
    note = fmt::format("{} nodes, {} quads, and heads", count(m.at("topology").at("nodes")),
                       count(m.at("topology").at("quads")));
  if (m.at("slb").is_null()) return note;
  if (!note.empty()) note += " + ";
  return note + fmt::format("{} pixels × {} bit, and scratch", count(m.at("slb").at("pixels")),
                            memory.at("slb_entry_bits").dump());
}

Json key_figures(const Json& m) {
  const Json& fixed_errors = m.at("errors").at("fixed");
  const Json& time = m.at("run_time");
  Json tiles = Json::array();
  tiles.push_back(
      tile("voxels", count(m.at("voxels").at("count")),
           !m.at("topology").is_null()
               ? fmt::format("{} of them uncertain", share(m.at("topology").at("uncertain_share")))
           : m.at("plane").is_null()
               ? std::string("the scene, sampled")
               : fmt::format("{} of them uncertain", share(m.at("voxels").at("uncertain_share")))));
  tiles.push_back(
      tile("mislabelled, unambiguous", share(fixed_errors.at("unambiguous").at("share")),
           fmt::format("{} of all voxels, {} of steady ones", share(fixed_errors.at("all").at("share")),
                       share(fixed_errors.at("steady").at("share")))));
  tiles.push_back(tile("boundary displacement", number(fixed_errors.at("boundary_displacement"), 3),
                       m.at("slb").is_null() ? "plane entries, mean" : "pixels of the plane, mean"));
  if (!m.at("cycles").is_null()) {
    add_rates(m, tiles);
    tiles.push_back(tile(
        "hardware time", seconds(time.at("seconds_at_clock")),
        fmt::format("{} cycles at {:g} MHz", count(time.at("cycles")), time.at("clock_mhz").get<double>())));
  }
  tiles.push_back(
      tile("hardware memory", bits(m.at("memory").at("hardware_bits").get<std::uint64_t>()), memory_note(m)));
  tiles.push_back(tile(
      "host time", seconds(time.at("host_seconds")),
      time.at("simulation_mcycles_per_second").is_null()
          ? std::string("all stages")
          : fmt::format("simulated at {} Mcycles/s", number(time.at("simulation_mcycles_per_second"), 2))));
  if (const Json& frames = m.at("frames"); !frames.is_null())
    tiles.push_back(tile("seconds a frame", number(frames.at("seconds_per_frame"), 2),
                         fmt::format("{} frames, {} events of shadow work", count(frames.at("count")),
                                     count(frames.at("shadow_work")))));
  return tiles;
}

/// Of several techniques: the first comparison that failed, and what each came to.
Json joint_verdict(const Json& m) {
  const Json& techniques = m.at("techniques");
  if (techniques.empty()) return verdict_view(m.at("compare"));
  const Json* shown = &m.at("compare");
  std::string text;
  for (const Json& t : techniques) {
    if (!shown->at("failed").get<bool>() && t.at("compare").at("failed").get<bool>())
      shown = &t.at("compare");
    text +=
        (text.empty() ? "" : " · ") + plain(t.at("technique")) + ": " + plain(t.at("compare").at("verdict"));
  }
  Json view = verdict_view(*shown);
  view["verdict"] = text;
  return view;
}

}  // namespace

Json summary_section(const Json& m) {
  Json view = joint_verdict(m);
  view["shadow_source"] = !m.at("software").is_null() ? "the technique in software, asked at every sample"
                          : m.at("slb").is_null()     ? "the voxel states"
                                                      : "the silhouette-line buffer, asked at every sample";
  view["title"] = m.at("scene").at("name");
  view["source"] = m.at("scene").at("source");
  view["started"] = m.at("started");
  view["engine"] = m.at("engine");
  view["configuration_line"] = configuration_line(m);
  view["tiles"] = key_figures(m);
  view["lights"] = Json::array();
  for (const Json& light : m.at("lights")) view["lights"].push_back({{"text", light_text(light)}});
  view["command_line"] = m.at("command").at("line");
  const Json& mask = m.at("picture").at("mask");
  view["picture_error"] = fmt::format(
      "{} false shadow, {} false lit of {} samples; shadow masks overlap by {} (intersection over union), "
      "RMSE {}",
      count(mask.at("false_shadow")), count(mask.at("false_lit")), count(mask.at("samples")),
      number(m.at("picture").at("intersection_over_union"), 4), number(m.at("picture").at("rmse"), 4));
  return view;
}

}  // namespace gnomon::report
