// SPDX-License-Identifier: Apache-2.0
// What the commands have in common that turn a model's limit surface into files: mesh, voxelize.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/cli/command.hpp"
#include "host/cli/scene_input.hpp"

namespace gnomon::cli {

/// MODEL --res R -o FILE... --json --set KEY=VALUE...
struct SurfaceOptions {
  std::filesystem::path model;
  std::string res;  ///< as given; empty: the default
  std::vector<std::filesystem::path> outputs;
  bool json = false;
  std::vector<std::string> set;

  /// `output_help` says what an output may be.
  void add_to(CLI::App& command, const std::string& output_help);
  /// The model, without a ground unless one is set; `more` are settings like those of --set.
  Result<LoadedScene> load(Context& context, std::vector<std::string> more = {}) const;
  /// The figures and the names of the files, as --json prints them.
  void print_json(nlohmann::ordered_json figures) const;
  void print_outputs() const;  ///< one name a line
};

}  // namespace gnomon::cli
