// SPDX-License-Identifier: Apache-2.0
// Reads "C '<key>' <count>" lines; a key is a list of \1 name \2 value.
#include "tests/sim/coverage_points.hpp"

#include <sstream>
#include <stdexcept>

#include "sim/content_hash.hpp"

namespace gnomon::sim::test {

namespace {

std::map<std::string, std::string> fields(const std::string& key) {
  std::map<std::string, std::string> result;
  std::istringstream parts(key);
  std::string part;
  while (std::getline(parts, part, '\1')) {
    const auto middle = part.find('\2');
    if (middle != std::string::npos) result[part.substr(0, middle)] = part.substr(middle + 1);
  }
  return result;
}

/// "v_line/module" -> "line"
std::string kind_of(const std::string& page) {
  const std::string kind = page.substr(0, page.find('/'));
  return kind.starts_with("v_") ? kind.substr(2) : kind;
}

}  // namespace

void add_coverage(CoverageCounts& counts, const std::filesystem::path& file) {
  std::istringstream lines(read_file(file));
  std::string line;
  bool any = false;
  while (std::getline(lines, line)) {
    if (!line.starts_with("C '")) continue;
    const auto end = line.rfind("' ");
    if (end == std::string::npos) continue;
    const auto values = fields(line.substr(3, end - 3));
    const auto value = [&](const char* name) {
      const auto found = values.find(name);
      return found == values.end() ? std::string() : found->second;
    };
    const CoveragePoint point{kind_of(value("page")), std::filesystem::path(value("f")).filename().string(),
                              value("l").empty() ? 0 : std::stoi(value("l")), value("o")};
    counts[point] += std::stoull(line.substr(end + 2));
    any = true;
  }
  if (!any) throw std::runtime_error("no coverage data in " + file.string());
}

}  // namespace gnomon::sim::test
