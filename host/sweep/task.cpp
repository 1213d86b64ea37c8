// SPDX-License-Identifier: Apache-2.0
// Points that are to be measured.
#include "host/sweep/task.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>

#include "host/sweep/key.hpp"

namespace gnomon::sweep {
namespace {

/// What is not named here is taken for shared, so that a new parameter costs time at worst.
constexpr std::array<std::string_view, 31> kOfTechnique{"technique",
                                                        "plane",
                                                        "pitch",
                                                        "offset",
                                                        "margin",
                                                        "margin_tan_max",
                                                        "depth_bits",
                                                        "normal_bits",
                                                        "voxel_frac_bits",
                                                        "frac_bits",
                                                        "slope_bits",
                                                        "slb_preset",
                                                        "frags",
                                                        "rounding",
                                                        "subpixel_bits",
                                                        "query_bits",
                                                        "lift",
                                                        "clearance",
                                                        "sub_bits",
                                                        "span_log2",
                                                        "nodes_log2",
                                                        "quads_log2",
                                                        "clock_mhz",
                                                        "seed",
                                                        "threads",
                                                        "matrix_frac_bits",
                                                        "map_memory",
                                                        "map_side",
                                                        "pcf_kernel",
                                                        "ray_sag",
                                                        "order"};

std::string shared_signature(const Task& task) {
  std::string text = task.scene.string();
  for (const config::Parameter& parameter : config::parameters()) {
    if (of_technique(parameter)) continue;
    const config::Settings::Entry& entry = task.point.settings.entry(parameter.key);
    // Whether a light was asked for matters: one that was replaces the scene's own.
    text += fmt::format("\n{}={}{}", parameter.key, config::to_text(entry.value),
                        entry.origin == "default" ? "" : "!");
  }
  return text;
}

std::string configuration_json(const config::Settings& settings) {
  nlohmann::ordered_json all;
  for (const config::Parameter& parameter : config::parameters()) {
    const config::Value& value = settings.entry(parameter.key).value;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      all[std::string(parameter.key)] = *integer;
    } else if (const auto* number = std::get_if<double>(&value)) {
      all[std::string(parameter.key)] = *number;
    } else {
      all[std::string(parameter.key)] = config::to_text(value);
    }
  }
  return all.dump();
}

}  // namespace

Row row_of(const Task& task) {
  Row row;
  row.key = task.key;
  row.scene = task.scene.filename().string();
  row.configuration = configuration_json(task.point.settings);
  row.flags = fmt::format("{} {}", task.scene.string(), fmt::join(task.point.settings.as_flags(), " "));
  for (const std::string_view key : given_defaults(task.point.settings))
    row.flags += fmt::format(" --set {}={}", key, config::to_text(task.point.settings.entry(key).value));
  row.finished = now();
  return row;
}

std::vector<std::vector<const Task*>> groups_of(const std::vector<Task>& tasks) {
  std::map<std::string, std::size_t> place;
  std::vector<std::vector<const Task*>> groups;
  for (const Task& task : tasks) {
    const auto [at, added] = place.try_emplace(shared_signature(task), groups.size());
    if (added) groups.emplace_back();
    groups[at->second].push_back(&task);
  }
  return groups;
}

bool of_technique(const config::Parameter& parameter) {
  return parameter.part != config::Part::Run ||
         std::ranges::find(kOfTechnique, parameter.key) != kOfTechnique.end();
}

std::string now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace gnomon::sweep
