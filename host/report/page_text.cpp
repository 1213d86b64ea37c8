// SPDX-License-Identifier: Apache-2.0
// Values of metrics.json as the page writes them.
#include "host/report/page_text.hpp"

#include <fmt/format.h>

#include <utility>

#include "host/report/numbers.hpp"

namespace gnomon::report {

std::string count(const Json& value) {
  return with_commas(value.get<std::uint64_t>());
}
std::string share(const Json& value) {
  return value.is_null() ? kNone : percent(value.get<double>());
}
std::string number(const Json& value, int digits) {
  return value.is_null() ? kNone : fixed(value.get<double>(), digits);
}
std::string seconds(const Json& value) {
  return value.is_null() ? kNone : duration(value.get<double>());
}
std::string plain(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Json row(std::string name, std::string value) {
  return {{"name", std::move(name)}, {"value", std::move(value)}};
}

std::string wall_text(const Json& metrics, std::string_view stage) {
  for (const Json& s : metrics.at("stages")) {
    if (s.at("name") == stage) return seconds(s.at("wall_seconds"));
  }
  return kNone;
}

std::string configuration_line(const Json& m) {
  const Json& h = m.at("hardware");
  std::string line = fmt::format("{} · {}³ voxels, {}-adjacent", m.at("technique").get<std::string>(),
                                 m.at("grid").at("res").dump(), m.at("grid").at("adjacency").dump());
  const auto plane = [&](const Json& p) {
    return fmt::format("{}², pitch {:.4g}", p.at("side").dump(), p.at("pitch").get<double>());
  };
  const auto list = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) line += fmt::format(" · {} {}", name, h.at(name).dump());
  };
  if (!m.at("plane").is_null()) {
    line += " · plane " + plane(m.at("plane"));
    list({"VOXEL_FRAC_BITS", "NORMAL_BITS", "MATRIX_FRAC_BITS"});
  }
  if (!m.at("topology").is_null()) {
    line += " · plane " + plane(m.at("topology"));
    list({"VOXEL_FRAC_BITS", "NORMAL_BITS", "MATRIX_FRAC_BITS", "SUB_BITS", "NODES_LOG2"});
  }
  if (!m.at("slb").is_null()) {
    line += " · silhouette-line buffer " + plane(m.at("slb"));
    list({"FRAC_BITS", "SLOPE_BITS", "FRAGS_PER_PIXEL"});
  }
  const Json& software = m.at("software");
  if (!software.is_null() && software.at("side") == 0) return line;
  if (!software.is_null()) {
    line += " · map " + plane(software);
    line += fmt::format(" · {0} × {0} texels a point", software.at("kernel").dump());
  }
  list({"DEPTH_BITS"});
  return line;
}

}  // namespace gnomon::report
