// SPDX-License-Identifier: Apache-2.0
// Verilator's coverage data: which points of the RTL a run has reached.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

namespace gnomon::sim::test {

/// A line or branch, or a bit that should toggle.
struct CoveragePoint {
  std::string kind;  ///< "line", "branch", "toggle", ...
  std::string file;  ///< name without folders
  int line = 0;
  std::string name;  ///< of the bit, or what kind of block

  bool operator<(const CoveragePoint& other) const {
    return std::tie(kind, file, line, name) < std::tie(other.kind, other.file, other.line, other.name);
  }
};

/// How often each point was reached.
using CoverageCounts = std::map<CoveragePoint, std::uint64_t>;

/// Adds a file that RtlEngine::write_coverage wrote; instances of a module count together. Throws
/// std::runtime_error if it is no such file.
void add_coverage(CoverageCounts& counts, const std::filesystem::path& file);

}  // namespace gnomon::sim::test
