// SPDX-License-Identifier: Apache-2.0
// A sweep as its author wrote it. Format: docs/sweep.md, "Specification".
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/sweep/axis.hpp"
#include "host/sweep/constraint.hpp"

namespace gnomon::sweep {

enum class Method : std::uint8_t { Grid, Random, LatinHypercube };

struct Sample {
  Method method = Method::Grid;
  std::size_t points = 0;  ///< a scene; grid: not used
  std::uint64_t seed = 1;
};

/// Values of parameters as they would be written after --set, by key.
using Assignments = std::map<std::string, std::string>;

struct Spec {
  std::string name;
  std::string text;  ///< the file's content
  std::vector<std::filesystem::path>
      scenes;  ///< at least one; relative to the working directory, or absolute
  Assignments fixed;
  std::vector<Axis> axes;         ///< by key, ascending
  std::vector<Assignments> list;  ///< points besides the axes'
  Sample sample;
  std::vector<std::string> constraints;
};

/// Errors are one line, "path:line: error: ...".
Result<Spec> read_spec(const std::filesystem::path& path);

}  // namespace gnomon::sweep
