// SPDX-License-Identifier: Apache-2.0
// From a specification to points with keys.
#include "host/cli/sweep_tasks.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "host/cli/versions.hpp"
#include "host/scene/scene_file.hpp"
#include "host/sweep/key.hpp"
#include "host/sweep/points.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

/// The files whose content makes a scene.
Result<std::vector<fs::path>> files_of(const fs::path& scene) {
  std::vector<fs::path> files{scene};
  if (!scene::is_scene_file(scene)) return files;
  const Result<scene::SceneFile> file = scene::read_scene_file(scene);
  if (!file) return tl::make_unexpected(file.error());
  for (const scene::SceneFile::Model& model : file->models) files.push_back(model.path);
  return files;
}

}  // namespace

Result<std::vector<sweep::Task>> tasks_of(const sweep::Spec& spec) {
  std::vector<std::vector<config::Assignment>> parameters;
  std::vector<std::string> hashes;
  for (const fs::path& scene : spec.scenes) {
    auto own = scene::scene_parameters(scene);
    if (!own) return tl::make_unexpected(own.error());
    parameters.push_back(std::move(*own));
    const auto files = files_of(scene);
    if (!files) return tl::make_unexpected(files.error());
    try {
      hashes.push_back(sweep::scene_hash(*files));
    } catch (const std::runtime_error& problem) {
      return fail(problem.what());
    }
  }
  auto points = sweep::expand(spec, parameters);
  if (!points) return tl::make_unexpected(points.error());
  const std::string version = versions().front().second;
  std::vector<sweep::Task> tasks;
  for (sweep::Point& point : *points) {
    std::string key = sweep::point_key(hashes[point.scene], point.settings, version);
    fs::path scene = spec.scenes[point.scene];
    tasks.push_back({std::move(point), std::move(key), std::move(scene)});
  }
  return tasks;
}

Result<Shard> Shard::parse(const std::string& text) {
  if (text.empty()) return Shard{};
  Shard shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  const bool slash = first.ec == std::errc() && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.count) : first;
  if (!slash || second.ec != std::errc() || second.ptr != end || shard.index < 1 || shard.index > shard.count)
    return fail(fmt::format("--shard {}: expected i/n, 1 <= i <= n", text));
  --shard.index;
  return shard;
}

std::string Shard::file() const {
  return count == 1 ? kSweepResults : fmt::format("shard-{}-of-{}.sqlite", index + 1, count);
}

}  // namespace gnomon::cli
