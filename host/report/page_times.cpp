// SPDX-License-Identifier: Apache-2.0
// Where the time went: cycles of the hardware, stages of the host.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "host/report/bars.hpp"
#include "host/report/numbers.hpp"
#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

struct Cause {
  const char* key;
  const char* name;
  const char* style;
};
constexpr std::array<Cause, 6> kCauses{{{"BUSY", "busy", "c-busy"},
                                        {"INPUT_STARVED", "input starved", "c-input"},
                                        {"OUTPUT_BLOCKED", "output blocked", "c-output"},
                                        {"MEMORY_WAIT", "memory wait", "c-memory"},
                                        {"HAZARD", "hazard", "c-hazard"},
                                        {"IDLE", "idle", "c-idle"}}};

Json pass_row(const std::string& name, const Json& pass, double longest, std::uint64_t all) {
  std::vector<Segment> segments;
  Json causes = Json::array();
  for (const Cause& cause : kCauses) {
    const std::uint64_t cycles = pass.at("causes").value(cause.key, std::uint64_t{0});
    segments.push_back({cause.style, fmt::format("{} · {}: {} cycles", name, cause.name, with_commas(cycles)),
                        static_cast<double>(cycles)});
    causes.push_back(with_commas(cycles));
  }
  const auto total = pass.at("total").get<std::uint64_t>();
  return {{"name", name},
          {"bar", stacked_bar(segments, longest, fmt::format("{}: {} cycles", name, with_commas(total)))},
          {"total", with_commas(total)},
          {"share", all > 0 ? percent(static_cast<double>(total) / static_cast<double>(all)) : kNone},
          {"causes", causes}};
}

}  // namespace

Json cycle_section(const Json& m) {
  const Json& cycles = m.at("cycles");
  if (cycles.is_null()) return {{"cycles", false}};
  double longest = 1;
  for (const auto& [name, pass] : cycles.at("by_pass").items())
    longest = std::max(longest, pass.at("total").get<double>());
  const auto all = cycles.at("total").get<std::uint64_t>();
  Json passes = Json::array();
  for (const auto& [name, pass] : cycles.at("by_pass").items())
    if (pass.at("total") != 0) passes.push_back(pass_row(name, pass, longest, all));
  Json causes = Json::array();
  for (const Cause& cause : kCauses) causes.push_back({{"name", cause.name}, {"style", cause.style}});
  return {{"cycles", {{"passes", passes}, {"causes", causes}, {"total", with_commas(all)}}}};
}

Json stage_section(const Json& m) {
  double full = 0;
  for (const Json& s : m.at("stages")) full += s.at("wall_seconds").get<double>();
  Json stages = Json::array();
  double start = 0;
  for (const Json& s : m.at("stages")) {
    const auto wall = s.at("wall_seconds").get<double>();
    const auto name = s.at("name").get<std::string>();
    const std::string text =
        fmt::format("{}: {} wall, {} user CPU", name, duration(wall), seconds(s.at("user_seconds")));
    stages.push_back({{"name", name},
                      {"bar", waterfall_bar({"c-stage", text, wall}, start, full, text)},
                      {"wall", duration(wall)},
                      {"user", seconds(s.at("user_seconds"))}});
    start += wall;
  }
  return {{"stages", stages}, {"stages_total", duration(full)}};
}

}  // namespace gnomon::report
