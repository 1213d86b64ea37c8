// SPDX-License-Identifier: Apache-2.0
// From the figures of a run to those of a point.
#include "host/sweep/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace gnomon::sweep {
namespace {

using Json = nlohmann::ordered_json;

/// The parts of metrics.json that hold figures; the others say what was run.
constexpr std::array<std::string_view, 13> kParts{"errors", "quantisation", "cycles", "run_time", "memory",
                                                  "plane",  "topology",     "slb",    "software", "voxels",
                                                  "events", "compare",      "system"};

/// Figures of the host and of the simulation, which no two runs have in common.
bool measures_time(const std::string& name) {
  return name.starts_with("run_time.host") || name.starts_with("run_time.simulation") ||
         name == "software.build_seconds" || name == "software.seconds" || name == "voxels.seconds" ||
         name == "voxels.mvoxels_per_second";
}

/// What a run counts of its whole stream, error samples and pictures included, or reads back.
constexpr std::array<std::string_view, 8> kOfWholeRuns{
    "events.COMMANDS",     "events.SLB_QUERIES", "slb.queries",    "slb.full_pixels",
    "slb.overflow_pixels", "memory.command_",    "memory.result_", "host.run_time"};

void flatten(const Json& part, const std::string& name, std::map<std::string, double>& figures) {
  if (part.is_object()) {
    for (const auto& [key, value] : part.items()) flatten(value, fmt::format("{}.{}", name, key), figures);
  } else if (part.is_number()) {
    figures.emplace(measures_time(name) ? "host." + name : name, part.get<double>());
  }
}

/// "golden engine" is "seconds.golden"; what is neither engine is the host's.
void add_stages(const Json& stages, std::map<std::string, double>& figures) {
  double host = 0;
  for (const Json& stage : stages) {
    const std::string name = stage.at("name").get<std::string>();
    const double seconds = stage.at("wall_seconds").get<double>();
    if (name == "golden engine") {
      figures["seconds.golden"] = seconds;
    } else if (name == "software technique") {
      figures["seconds.software"] = seconds;
    } else if (name == "rtl engine" || name == "system engine") {
      figures["seconds.rtl"] = seconds;
    } else if (name != "rtl model") {  // compiled once, for all who come after
      host += seconds;
    }
  }
  figures["seconds.host"] = host;
}

}  // namespace

Measurement measurement_of(const Json& metrics) {
  Measurement measured;
  for (const std::string_view part : kParts) {
    const std::string name(part);
    if (metrics.contains(name)) flatten(metrics.at(name), name, measured.figures);
  }
  if (metrics.contains("stages")) add_stages(metrics.at("stages"), measured.figures);
  const auto displaced = measured.figures.find("errors.fixed.boundary_displacement");
  const auto pitch = measured.figures.find("errors.pitch");
  if (displaced != measured.figures.end() && pitch != measured.figures.end())
    measured.figures["errors.fixed.border_voxels"] = displaced->second * pitch->second;
  for (const char* label : {"technique", "engine"}) {
    if (metrics.contains(label) && metrics.at(label).is_string())
      measured.labels.emplace(label, metrics.at(label).get<std::string>());
  }
  return measured;
}

void drop_unasked(Measurement& measured) {
  std::erase_if(measured.figures, [](const auto& figure) {
    return std::ranges::any_of(kOfWholeRuns,
                               [&](std::string_view prefix) { return figure.first.starts_with(prefix); });
  });
}

}  // namespace gnomon::sweep
