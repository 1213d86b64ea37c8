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
  const bool compared = compare["compared"], failed = compare["failed"];
  Json view = {{"verdict_good", compared && !failed}, {"verdict_bad", failed},
               {"verdict_none", !compared},           {"verdict", compare["verdict"]},
               {"difference_text", compare["text"]},  {"first", false}};
  if (const Json& first = compare["first_difference"]; !first.is_null()) {
    const auto word = [&](const char* engine) {
      return first[engine].is_null()
                 ? std::string("no such word")
                 : fmt::format("{} {}", plain(first[engine]["word"]), plain(first[engine]["fields"]));
    };
    view["first"] = {
        {"word", count(first["result_index"])},
        {"command", first.contains("command") ? plain(first["command"]) : kNone},
        {"command_index", first.contains("command_index") ? count(first["command_index"]) : kNone},
        {"cycle", first.contains("cycle") ? count(first["cycle"]) : kNone},
        {"item", first.contains("item") ? plain(first["item"]) : kNone},
        {"expected", word("expected")},
        {"actual", word("rtl")}};
  }
  return view;
}

Json key_figures(const Json& m) {
  const Json& fixed_errors = m["errors"]["fixed"];
  const Json& time = m["run_time"];
  Json tiles = Json::array();
  tiles.push_back(tile("voxels", count(m["voxels"]["count"]),
                       fmt::format("{} of them uncertain", share(m["voxels"]["uncertain_share"]))));
  tiles.push_back(tile("mislabelled, unambiguous", share(fixed_errors["unambiguous"]["share"]),
                       share(fixed_errors["all"]["share"]) + " of all voxels"));
  tiles.push_back(
      tile("boundary displacement", number(fixed_errors["boundary_displacement"], 3), "plane entries, mean"));
  if (!m["cycles"].is_null()) {
    const Json& per_voxel = m["cycles"]["per_voxel"];
    tiles.push_back(tile("cycles a voxel",
                         number(per_voxel["project"], 3) + " + " + number(per_voxel["resolve"], 3),
                         "project + resolve"));
    tiles.push_back(
        tile("hardware time", seconds(time["seconds_at_clock"]),
             fmt::format("{} cycles at {:g} MHz", count(time["cycles"]), time["clock_mhz"].get<double>())));
  }
  tiles.push_back(tile("plane memory", bits(m["memory"]["plane_bits"].get<std::uint64_t>()),
                       fmt::format("{} entries × {} bit", count(m["memory"]["plane_entries"]),
                                   m["memory"]["plane_entry_bits"].dump())));
  tiles.push_back(
      tile("host time", seconds(time["host_seconds"]),
           time["simulation_mcycles_per_second"].is_null()
               ? std::string("all stages")
               : fmt::format("simulated at {} Mcycles/s", number(time["simulation_mcycles_per_second"], 2))));
  return tiles;
}

std::string light_text(const Json& light) {
  const bool directional = light["type"] == "directional";
  const Json& v = light[directional ? "direction" : "position"];
  return fmt::format("{} ({:.4g}, {:.4g}, {:.4g})", directional ? "directional, travelling" : "point at",
                     v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
}

}  // namespace

Json summary_section(const Json& m) {
  Json view = verdict_view(m["compare"]);
  view["title"] = m["scene"]["name"];
  view["source"] = m["scene"]["source"];
  view["started"] = m["started"];
  view["engine"] = m["engine"];
  view["configuration_line"] = configuration_line(m);
  view["tiles"] = key_figures(m);
  view["lights"] = Json::array();
  for (const Json& light : m["lights"]) view["lights"].push_back({{"text", light_text(light)}});
  view["command_line"] = m["command"]["line"];
  const Json& mask = m["picture"]["mask"];
  view["picture_error"] = fmt::format(
      "{} false shadow, {} false lit of {} samples; shadow masks overlap by {} (intersection over union), "
      "RMSE {}",
      count(mask["false_shadow"]), count(mask["false_lit"]), count(mask["samples"]),
      number(m["picture"]["intersection_over_union"], 4), number(m["picture"]["rmse"], 4));
  return view;
}

}  // namespace gnomon::report
