// SPDX-License-Identifier: Apache-2.0
// Keys of points.
#include "host/sweep/key.hpp"

#include <algorithm>
#include <array>

#include "sim/content_hash.hpp"

namespace gnomon::sweep {
namespace {

constexpr std::array<std::string_view, 3> kOfNoConsequence{"threads", "image_width", "image_height"};

bool is_given(const config::Settings& settings, std::string_view key) {
  return settings.entry(key).origin != "default";
}

bool has_default(const config::Settings& settings, const config::Parameter& parameter) {
  return settings.entry(parameter.key).value == parameter.preset;
}

}  // namespace

std::vector<std::string_view> given_defaults(const config::Settings& settings) {
  std::vector<std::string_view> keys, of_memory;
  bool memory_told = false;  // by a value that is no default
  for (const config::Parameter& parameter : config::parameters()) {
    const bool of_default = has_default(settings, parameter);
    if (parameter.part == config::Part::Memory) {
      memory_told = memory_told || !of_default;
      if (is_given(settings, parameter.key)) of_memory.push_back(parameter.key);
    }
    const bool matters = parameter.key == "light" ||
                         (parameter.key == "pitch" && settings.word("technique") == "voxel-topology");
    if (matters && of_default && is_given(settings, parameter.key)) keys.push_back(parameter.key);
  }
  // One of them tells the same as many.
  if (!memory_told && !of_memory.empty()) keys.push_back(of_memory.front());
  return keys;
}

std::string scene_hash(std::span<const std::filesystem::path> files) {
  std::string hashes;
  for (const std::filesystem::path& file : files) hashes += sim::content_hash(sim::read_file(file));
  return sim::content_hash(hashes);
}

std::string point_key(std::string_view scene, const config::Settings& settings,
                      std::string_view model_version) {
  std::string text(scene);
  text += '\n';
  text += model_version;
  for (const config::Parameter& parameter : config::parameters()) {
    if (std::ranges::find(kOfNoConsequence, parameter.key) != kOfNoConsequence.end()) continue;
    text += '\n';
    text += parameter.key;
    text += '=';
    text += config::to_text(settings.entry(parameter.key).value);
  }
  for (const std::string_view key : given_defaults(settings)) {
    text += "\ngiven ";
    text += (*config::find_parameter(key))->part == config::Part::Memory ? "memory" : key;
  }
  return sim::content_hash(text);
}

}  // namespace gnomon::sweep
