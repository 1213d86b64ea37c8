// SPDX-License-Identifier: Apache-2.0
// Baselines as JSON.
#include "host/regression/baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/content_hash.hpp"

namespace gnomon::regression {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;  // grows when older programs would misread a baseline

Baseline from_json(const Json& json) {
  if (json.at("baseline_format") != kFormat)
    throw std::runtime_error(
        fmt::format("baseline_format is {}, expected {}", json.at("baseline_format").dump(), kFormat));
  Baseline baseline;
  baseline.settings = json.at("settings").get<std::vector<std::string>>();
  for (const auto& [scene, entry] : json.at("scenes").items()) {
    SceneFigures figures{scene, entry.at("configuration").get<std::string>(), {}};
    for (const auto& [name, value] : entry.at("figures").items()) {
      if (!value.is_primitive() || value.is_boolean())
        throw std::runtime_error(fmt::format("{}: {} is no figure", scene, name));
      figures.figures[name] = value;
    }
    baseline.scenes.push_back(std::move(figures));
  }
  return baseline;
}

}  // namespace

const SceneFigures* Baseline::find(const std::string& scene) const {
  const auto at = std::ranges::find(scenes, scene, &SceneFigures::scene);
  return at == scenes.end() ? nullptr : &*at;
}

void Baseline::put(SceneFigures figures) {
  const auto at = std::ranges::find(scenes, figures.scene, &SceneFigures::scene);
  if (at == scenes.end()) {
    scenes.push_back(std::move(figures));
  } else {
    *at = std::move(figures);
  }
}

Result<Baseline> read_baseline(const std::filesystem::path& file) try {
  return from_json(Json::parse(sim::read_file(file)));
} catch (const Json::exception& problem) {
  return fail(fmt::format("{}: error: is no baseline: {}", file.string(), problem.what()));
} catch (const std::runtime_error& problem) {
  return fail(fmt::format("{}: error: {}", file.string(), problem.what()));
}

std::string to_text(const Baseline& baseline) {
  Json scenes = Json::object();
  for (const SceneFigures& scene : baseline.scenes)
    scenes[scene.scene] = {{"configuration", scene.configuration}, {"figures", scene.figures}};
  return Json{{"baseline_format", kFormat}, {"settings", baseline.settings}, {"scenes", scenes}}.dump(1) +
         "\n";
}

}  // namespace gnomon::regression
