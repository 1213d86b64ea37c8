// SPDX-License-Identifier: Apache-2.0
// Queries from a CSV file, answers to one (docs/slb-cli.md, "Queries").
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/slb/loop_scene.hpp"

namespace gnomon::slb {

struct QueryFile {
  std::vector<Receiver> receivers;
  bool has_header = false;  ///< the first line reads "x,y,z"
};

/// Rows of three finite numbers. Errors are one line, "path:line: error: ...".
Result<QueryFile> read_queries(const std::filesystem::path& path);

/// "0" (lit) or "1" (in shadow) a line.
std::string answers_text(const std::vector<bool>& shadows);

}  // namespace gnomon::slb
