// SPDX-License-Identifier: Apache-2.0
// Reads polygon loops from a JSON file (docs/slb-cli.md, "Loops").
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/slb/loop_scene.hpp"

namespace gnomon::slb {

struct LoopFile {
  LoopScene scene;
  std::vector<std::string> notes;  ///< what was ignored or repaired, "path: ..."
};

/// Every loop has three or more vertices, all numbers are finite, depths lie in 0..1. A loop whose last
/// vertex repeats its first loses it, with a note. Errors are one line that names object, loop and vertex,
/// counted from 0.
Result<LoopFile> read_loops(const std::filesystem::path& path);

}  // namespace gnomon::slb
