// SPDX-License-Identifier: Apache-2.0
// A baseline: figures of scenes as they are meant to be, in a JSON file that is kept with the sources.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/regression/figures.hpp"

namespace gnomon::regression {

struct SceneFigures {
  std::string scene;          ///< path, from the baseline's directory
  std::string configuration;  ///< hash of everything that its figures follow from but the program
  Figures figures;
};

struct Baseline {
  std::vector<std::string> settings;  ///< key=value, as for --set
  std::vector<SceneFigures> scenes;

  /// Null where it has none of that path.
  const SceneFigures* find(const std::string& scene) const;
  /// In the place of one of the same path, else as the last.
  void put(SceneFigures figures);
};

/// Fails with one line, naming the file, if it cannot be read or is no baseline.
Result<Baseline> read_baseline(const std::filesystem::path& file);
/// What read_baseline reads; figures in a line each, so that a version control shows what changed.
std::string to_text(const Baseline& baseline);

}  // namespace gnomon::regression
