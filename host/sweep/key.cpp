// SPDX-License-Identifier: Apache-2.0
// Keys of points.
#include "host/sweep/key.hpp"

#include <algorithm>
#include <array>

#include "sim/content_hash.hpp"

namespace gnomon::sweep {
namespace {

constexpr std::array<std::string_view, 3> kOfNoConsequence{"threads", "image_width", "image_height"};

}  // namespace

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
  return sim::content_hash(text);
}

}  // namespace gnomon::sweep
