// SPDX-License-Identifier: Apache-2.0
// What most subcommands begin with: a model or scene, and the parameters that apply to it.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/config/settings.hpp"
#include "host/scene/scene.hpp"

namespace gnomon::cli {

struct LoadedScene {
  scene::Scene scene;
  config::Settings settings;
  double seconds = 0;       ///< wall time of loading
  double user_seconds = 0;  ///< CPU time of loading
};

/// "--set key=value", repeatable.
void add_set_option(CLI::App& command, std::vector<std::string>& flags);

/// The parameters of a command without a scene: flag > environment > default.
Result<config::Settings> load_settings(const std::vector<std::string>& set_flags);

/// Resolves the parameters (flag > environment > scene file > `presets` > default), loads the scene and logs
/// what was ignored or repaired.
Result<LoadedScene> load_input(Context& context, const std::filesystem::path& path,
                               const std::vector<std::string>& set_flags,
                               const std::vector<config::Assignment>& presets = {});

/// What the parameters say about a scene file, or a bare OBJ.
scene::SceneOptions scene_options(const config::Settings& settings);

voxel::Adjacency adjacency_of(const config::Settings& settings);

/// Seconds of CPU that this process has used in user mode.
double user_cpu_seconds();

}  // namespace gnomon::cli
