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
  const Json& all = errors["all"];
  const Json& unambiguous = errors["unambiguous"];
  return {{"name", name},
          {"note", note},
          {"all", count(all["mislabelled"])},
          {"all_share", share(all["share"])},
          {"unambiguous", count(unambiguous["mislabelled"])},
          {"unambiguous_share", share(unambiguous["share"])},
          {"false_shadow", count(all["false_shadow"])},
          {"false_lit", count(all["false_lit"])},
          {"boundary", number(errors["boundary_displacement"], 4)}};
}

Json exact_row() {
  return {{"name", "exact"},
          {"note", "rays against the limit surface"},
          {"all", "0"},
          {"all_share", "by definition"},
          {"unambiguous", "0"},
          {"unambiguous_share", "by definition"},
          {"false_shadow", "0"},
          {"false_lit", "0"},
          {"boundary", "0"},
          {"cycles", kNone},
          {"time_at_clock", kNone}};
}

Json receiver_row(const Json& m, const char* method, const char* key, const char* receiver) {
  const Json& part = m["errors"][key][receiver];
  return {{"method", method},
          {"receiver", receiver},
          {"samples", count(part["all"]["samples"])},
          {"all", share(part["all"]["share"])},
          {"unambiguous", share(part["unambiguous"]["share"])},
          {"surface", share(part["samples"]["share"])},
          {"boundary", number(part["boundary_displacement"], 4)}};
}

}  // namespace

Json error_section(const Json& m) {
  const Json& time = m["run_time"];
  const bool rtl = !m["cycles"].is_null();
  const std::string plane = bits(m["memory"]["plane_bits"].get<std::uint64_t>());

  Json hardware = error_row(m["errors"]["fixed"], "fixed point", "the hardware, to the bit");
  hardware["cycles"] = rtl ? count(time["cycles"]) : "not simulated";
  hardware["time_at_clock"] = rtl ? seconds(time["seconds_at_clock"]) : kNone;
  hardware["host"] = rtl ? wall_text(m, kRtlStage) + " rtl, " + wall_text(m, kGoldenStage) + " golden"
                         : wall_text(m, kGoldenStage) + " golden";
  hardware["memory"] = plane;
  Json in_double = error_row(m["errors"]["double"], "double", "the same method, no rounding to speak of");
  in_double["cycles"] = in_double["time_at_clock"] = kNone;
  in_double["host"] = wall_text(m, kDoubleStage);
  in_double["memory"] = bits(64 * m["memory"]["plane_entries"].get<std::uint64_t>());
  Json exact = exact_row();
  exact["host"] = wall_text(m, kExactStage);
  exact["memory"] = count(m["exact_reference"]["triangles"]) + " triangles";

  const Json& q = m["errors"]["quantisation"];
  Json view;
  view["clock"] = fmt::format("{:g} MHz", time["clock_mhz"].get<double>());
  view["error_rows"] = Json::array({hardware, in_double, exact});
  view["quantisation"] = fmt::format(
      "{} voxels ({}) get another answer in fixed point than in double; {} ({}) of the unambiguous ones.",
      count(q["differing"]), share(q["share"]), count(q["unambiguous_differing"]),
      share(q["unambiguous_share"]));
  view["receivers"] = Json::array(
      {receiver_row(m, "fixed point", "fixed", "ground"), receiver_row(m, "fixed point", "fixed", "models"),
       receiver_row(m, "double", "double", "ground"), receiver_row(m, "double", "double", "models")});
  return view;
}

}  // namespace gnomon::report
