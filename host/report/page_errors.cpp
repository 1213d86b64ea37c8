// SPDX-License-Identifier: Apache-2.0
// Error against run time: one line a method, every error beside what it costs.
#include <fmt/format.h>

#include <string>

#include "host/report/metrics_json.hpp"
#include "host/report/numbers.hpp"
#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

/// One method's line of "error against run time".
Json error_row(const Json& errors, const char* name, const char* note) {
  const Json& all = errors.at("all");
  const Json& unambiguous = errors.at("unambiguous");
  const Json& steady = errors.at("steady");
  return {{"name", name},
          {"note", note},
          {"all", count(all.at("mislabelled"))},
          {"all_share", share(all.at("share"))},
          {"unambiguous", count(unambiguous.at("mislabelled"))},
          {"unambiguous_share", share(unambiguous.at("share"))},
          {"steady", count(steady.at("mislabelled"))},
          {"steady_share", share(steady.at("share"))},
          {"false_shadow", count(all.at("false_shadow"))},
          {"false_lit", count(all.at("false_lit"))},
          {"boundary", number(errors.at("boundary_displacement"), 4)}};
}

Json exact_row() {
  return {{"name", "exact"},
          {"note", "rays against the limit surface"},
          {"all", "0"},
          {"all_share", "by definition"},
          {"unambiguous", "0"},
          {"unambiguous_share", "by definition"},
          {"steady", "0"},
          {"steady_share", "by definition"},
          {"false_shadow", "0"},
          {"false_lit", "0"},
          {"boundary", "0"},
          {"cycles", kNone},
          {"time_at_clock", kNone}};
}

/// Where nothing was simulated: what the cycle model says, but for READ as with the hardware's.
std::string predicted_cycles(const Json& m) {
  const Json& predicted = m.at("cycles_predicted");
  if (predicted.is_null()) return "not simulated";
  auto cycles = predicted.at("total").get<std::uint64_t>();
  if (const Json& passes = predicted.at("by_pass"); passes.contains("READ"))
    cycles -= passes.at("READ").at("total").get<std::uint64_t>();
  return with_commas(cycles) + " predicted";
}

/// A shadow map of so many pixels: no hardware of ours, but what it would need.
Json shadow_map_row(const Json& m, const Json& map) {
  const double ours = m.at("errors").at("fixed").at("ground").at("boundary_displacement").is_null()
                          ? 0
                          : m.at("errors").at("fixed").at("ground").at("boundary_displacement").get<double>();
  Json line = error_row(map, "shadow map", "");
  line["name"] = fmt::format("shadow map {0}²", map.at("side").dump());
  const Json& theirs = map.at("ground").at("boundary_displacement");
  line["note"] = ours > 0 && !theirs.is_null()
                     ? fmt::format("nearest depth; its border on the ground is off {:.3g} times as far",
                                   theirs.get<double>() / ours)
                     : std::string("nearest depth at each pixel's centre");
  line["cycles"] = line["time_at_clock"] = kNone;
  line["host"] = wall_text(m, kShadowMapStage);
  line["memory"] = bits(map.at("memory_bits").get<std::uint64_t>());
  return line;
}

Json receiver_row(const Json& m, const char* method, const char* key, const char* receiver) {
  const Json& part = m.at("errors").at(key).at(receiver);
  return {{"method", method},
          {"receiver", receiver},
          {"samples", count(part.at("all").at("samples"))},
          {"all", share(part.at("all").at("share"))},
          {"unambiguous", share(part.at("unambiguous").at("share"))},
          {"steady", share(part.at("steady").at("share"))},
          {"surface", share(part.at("samples").at("share"))},
          {"length", number(part.at("boundary_length"), 0)},
          {"boundary", number(part.at("boundary_displacement"), 4)}};
}

/// The method in double, and what fixed point lost against it.
void add_double(const Json& m, Json& view) {
  Json line = error_row(m.at("errors").at("double"), "double", "the same method, no rounding to speak of");
  line["cycles"] = line["time_at_clock"] = kNone;
  line["host"] = wall_text(m, kDoubleStage);
  line["memory"] = bits(64 * m.at("memory").at("plane_entries").get<std::uint64_t>());
  view["error_rows"].push_back(line);
  for (const char* receiver : {"ground", "models"})
    view["receivers"].push_back(receiver_row(m, "double", "double", receiver));
  const Json& q = m.at("errors").at("quantisation");
  view["quantisation"] = {
      {"text", fmt::format("{} voxels ({}) get another answer in fixed point than in double; {} ({}) of the "
                           "unambiguous ones.",
                           count(q.at("differing")), share(q.at("share")),
                           count(q.at("unambiguous_differing")), share(q.at("unambiguous_share")))}};
}

}  // namespace

Json error_section(const Json& m) {
  const Json& time = m.at("run_time");
  const bool rtl = !m.at("cycles").is_null();
  const auto engine = m.at("engine").get<std::string>();
  const std::string memory = bits(m.at("memory").at("hardware_bits").get<std::uint64_t>());

  Json hardware = error_row(m.at("errors").at("fixed"), "fixed point", "the hardware, to the bit");
  hardware["cycles"] = rtl ? count(time.at("cycles")) : predicted_cycles(m);
  hardware["time_at_clock"] = rtl ? seconds(time.at("seconds_at_clock")) : kNone;
  hardware["host"] =
      rtl ? wall_text(m, engine_stage(engine)) + " " + engine + ", " + wall_text(m, kGoldenStage) + " golden"
          : wall_text(m, kGoldenStage) + " golden";
  hardware["memory"] = memory;
  Json exact = exact_row();
  exact["host"] = wall_text(m, kExactStage);
  exact["memory"] = count(m.at("exact_reference").at("triangles")) + " triangles";

  Json view;
  view["clock"] = fmt::format("{:g} MHz", time.at("clock_mhz").get<double>());
  view["error_rows"] = Json::array({hardware});
  view["receivers"] = Json::array(
      {receiver_row(m, "fixed point", "fixed", "ground"), receiver_row(m, "fixed point", "fixed", "models")});
  view["quantisation"] = false;
  if (!m.at("errors").at("double").is_null()) add_double(m, view);
  for (const Json& map : m.at("errors").at("shadow_maps"))
    view["error_rows"].push_back(shadow_map_row(m, map));
  view["error_rows"].push_back(exact);
  return view;
}

}  // namespace gnomon::report
