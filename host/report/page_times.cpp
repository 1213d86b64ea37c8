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

std::string with_sign(std::uint64_t predicted, std::uint64_t taken) {
  if (predicted == taken) return "0";
  return predicted > taken ? "+" + with_commas(predicted - taken) : "−" + with_commas(taken - predicted);
}

/// What the cycle model says of a pass; dashes where it says nothing.
void add_prediction(const Json& predicted, const std::string& name, std::uint64_t taken, Json& row) {
  row["predicted"] = row["off"] = kNone;
  if (predicted.is_null() || !predicted.at("by_pass").contains(name) || name == "IDLE") return;
  const auto cycles = predicted.at("by_pass").at(name).at("total").get<std::uint64_t>();
  row["predicted"] = with_commas(cycles);
  row["off"] = with_sign(cycles, taken);
}

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

/// How far the cycle model is off: of the passes' differences, none of which makes up for another.
std::string prediction_text(const Json& predicted, std::uint64_t taken) {
  if (predicted.is_null() || predicted.at("off").is_null()) return {};
  const auto off = predicted.at("off").get<std::uint64_t>();
  return fmt::format("The cycle model, from the command stream alone: {} cycles, {} off ({} of those taken).",
                     with_commas(predicted.at("total").get<std::uint64_t>()), with_commas(off),
                     taken > 0 ? percent(static_cast<double>(off) / static_cast<double>(taken)) : kNone);
}

}  // namespace

Json cycle_section(const Json& m) {
  const Json& predicted = m.at("cycles_predicted");
  const bool simulated = !m.at("cycles").is_null();
  const Json& cycles = simulated ? m.at("cycles") : predicted;
  if (cycles.is_null()) return {{"cycles", false}};
  double longest = 1;
  for (const auto& [name, pass] : cycles.at("by_pass").items())
    longest = std::max(longest, pass.at("total").get<double>());
  const auto all = cycles.at("total").get<std::uint64_t>();
  Json passes = Json::array();
  for (const auto& [name, pass] : cycles.at("by_pass").items()) {
    if (pass.at("total") == 0) continue;
    Json row = pass_row(name, pass, longest, all);
    if (simulated) add_prediction(predicted, name, pass.at("total").get<std::uint64_t>(), row);
    passes.push_back(std::move(row));
  }
  Json causes = Json::array();
  for (const Cause& cause : kCauses) causes.push_back({{"name", cause.name}, {"style", cause.style}});
  Json view = {{"passes", passes},
               {"causes", causes},
               {"total", with_commas(all)},
               {"only_predicted", !simulated},
               {"compared", simulated && !predicted.is_null()}};
  if (simulated && !predicted.is_null()) {
    view["predicted"] = with_commas(predicted.at("total").get<std::uint64_t>());
    view["off"] = count(predicted.at("off"));
    const Json& passes_taken = cycles.at("by_pass");
    const std::uint64_t idle =
        passes_taken.contains("IDLE") ? passes_taken.at("IDLE").at("total").get<std::uint64_t>() : 0;
    view["prediction"] = prediction_text(predicted, all - idle);
  }
  return {{"cycles", view}};
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
