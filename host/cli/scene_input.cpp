// SPDX-License-Identifier: Apache-2.0
// A model or scene, and the parameters that apply to it.
#include "host/cli/scene_input.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>

#include "host/scene/scene_file.hpp"

namespace gnomon::cli {
namespace {

Result<std::vector<config::Assignment>> from_flags(const std::vector<std::string>& flags) {
  std::vector<config::Assignment> assignments;
  for (const std::string& flag : flags) {
    Result<config::Assignment> assignment = config::parse_set_flag(flag);
    if (!assignment) return tl::make_unexpected(assignment.error());
    assignments.push_back(std::move(*assignment));
  }
  return assignments;
}

std::vector<config::Assignment> from_environment() {
  std::vector<std::string> entries;
  for (char** entry = environ; *entry != nullptr; ++entry) entries.emplace_back(*entry);
  return config::environment_assignments(entries);
}

}  // namespace

scene::SceneOptions scene_options(const config::Settings& settings) {
  scene::SceneOptions options;
  options.ground = settings.is_on("ground");
  options.up = settings.word("up") == "z" ? scene::UpAxis::Z : scene::UpAxis::Y;
  options.surface =
      settings.word("surface") == "polygon" ? scene::SurfaceKind::Polygons : scene::SurfaceKind::CatmullClark;
  options.image_aspect = static_cast<double>(settings.integer("image_width")) /
                         static_cast<double>(settings.integer("image_height"));
  if (settings.entry("light").origin != "default") {
    const auto [x, y, z] = settings.vector("light");
    options.light = Vec3(x, y, z);
  }
  return options;
}

void add_set_option(CLI::App& command, std::vector<std::string>& flags) {
  command.add_option("--set", flags, "Set a parameter; `gnomon params` lists them")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

Result<config::Settings> load_settings(const std::vector<std::string>& set_flags) {
  Result<std::vector<config::Assignment>> flags = from_flags(set_flags);
  if (!flags) return tl::make_unexpected(flags.error());
  const std::vector<std::vector<config::Assignment>> sources{from_environment(), std::move(*flags)};
  return config::Settings::resolve(sources);
}

Result<LoadedScene> load_input(Context& context, const std::filesystem::path& path,
                               const std::vector<std::string>& set_flags,
                               const std::vector<config::Assignment>& presets) {
  const auto start = std::chrono::steady_clock::now();
  const double user_start = user_cpu_seconds();
  Result<std::vector<config::Assignment>> flags = from_flags(set_flags);
  if (!flags) return tl::make_unexpected(flags.error());
  Result<std::vector<config::Assignment>> file = scene::scene_parameters(path);
  if (!file) return tl::make_unexpected(file.error());
  const std::vector<std::vector<config::Assignment>> sources{presets, std::move(*file), from_environment(),
                                                             std::move(*flags)};
  Result<config::Settings> settings = config::Settings::resolve(sources);
  if (!settings) return tl::make_unexpected(settings.error());
  Result<scene::Scene> scene = scene::load_scene(path, scene_options(*settings));
  if (!scene) return tl::make_unexpected(scene.error());
  for (const std::string& warning : scene->warnings) context.log->warn("{}", warning);
  context.interruption.check();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return LoadedScene{std::move(*scene), std::move(*settings), seconds, user_cpu_seconds() - user_start};
}

voxel::Adjacency adjacency_of(const config::Settings& settings) {
  return static_cast<voxel::Adjacency>(settings.integer("adjacency"));
}

double user_cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

}  // namespace gnomon::cli
