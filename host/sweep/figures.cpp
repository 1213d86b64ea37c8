// SPDX-License-Identifier: Apache-2.0
// Figures and varied parameters of a sweep's rows.
#include "host/sweep/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "host/config/parameter.hpp"
#include "host/sweep/front.hpp"

namespace gnomon::sweep {
namespace {

constexpr std::array<Figure, 18> kPlotted{{
    {"errors.fixed.boundary_displacement", "border displaced by, plane entries"},
    {"errors.fixed.border_voxels", "border displaced by, voxels"},
    {"errors.fixed.ground.boundary_displacement", "ground border displaced by, plane entries"},
    {"errors.fixed.all.share", "mislabelled voxels, share"},
    {"errors.fixed.unambiguous.share", "mislabelled unambiguous voxels, share"},
    {"model.cycles", "cycles, predicted"},
    {"rtl.cycles", "cycles of the hardware"},
    {"system.cycles", "cycles of the whole system"},
    {"memory.format_bits", "memory, bits of the formats"},
    {"memory.hardware_bits", "memory, bits as stored"},
    {"area.luts", "area, four-input tables (iCE40, estimated)"},
    {"area.dsps", "area, multipliers (iCE40, estimated)"},
    {"area.period_ns", "clock period, ns (HX8K, estimated)"},
    {"area.seconds", "time at the estimated clock, seconds"},
    {"seconds.golden", "golden engine, wall seconds"},
    {"seconds.rtl", "rtl engine, wall seconds"},
    {"seconds.software", "software technique, wall seconds"},
    {"seconds.host", "host, wall seconds"},
}};

constexpr const char* kArea = "area.luts";

std::optional<double> number(const std::string& text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// A line as RFC 4180 has it, but for its end.
std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string& cell = cells[i];
    if (i > 0) line.push_back(',');
    if (cell.find_first_of(",\"\n\r") == std::string::npos) {
      line.append(cell);
      continue;
    }
    line.push_back('"');
    for (const char c : cell) line.append(c == '"' ? 2 : 1, c);
    line.push_back('"');
  }
  line.push_back('\n');
  return line;
}

bool has(const Row& row, const char* figure) {
  return !row.failed() && row.figures.contains(figure);
}

/// Not a number where the row has no such figure or failed.
std::vector<double> objectives_of(const Row& row, const std::vector<const char*>& names) {
  std::vector<double> values;
  for (const char* name : names) {
    const auto figure = row.figures.find(name);
    values.push_back(has(row, name) ? figure->second : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

}  // namespace

std::span<const Figure> plotted_figures() {
  return kPlotted;
}

std::string parameter_text(const Row& row, const std::string& key) {
  const nlohmann::json configuration = nlohmann::json::parse(row.configuration, nullptr, false);
  if (!configuration.is_object() || !configuration.contains(key)) return {};
  const nlohmann::json& value = configuration.at(key);
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::vector<Varied> varied_parameters(const std::vector<Row>& rows) {
  std::vector<nlohmann::json> configurations;
  configurations.reserve(rows.size());
  for (const Row& row : rows)
    configurations.push_back(nlohmann::json::parse(row.configuration, nullptr, false));
  std::vector<Varied> varied;
  for (const config::Parameter& parameter : config::parameters()) {
    const std::string key(parameter.key);
    std::set<std::string> values;
    for (const nlohmann::json& configuration : configurations) {
      if (!configuration.is_object() || !configuration.contains(key)) continue;
      const nlohmann::json& value = configuration.at(key);
      values.insert(value.is_string() ? value.get<std::string>() : value.dump());
    }
    if (values.size() < 2) continue;
    Varied one{key, {values.begin(), values.end()}};
    std::ranges::stable_sort(one.values, [](const std::string& a, const std::string& b) {
      const auto x = number(a), y = number(b);
      return x && y ? *x < *y : x.has_value() && !y;
    });
    varied.push_back(std::move(one));
  }
  return varied;
}

bool is_published(const Row& row) {
  const std::string f = parameter_text(row, "frac_bits");
  return (f == "4" || f == "7") && parameter_text(row, "slope_bits") == f &&
         parameter_text(row, "technique").starts_with("slb");
}

bool marks_published(const std::vector<Row>& rows) {
  return std::ranges::any_of(rows, [](const Row& row) {
    return parameter_text(row, "technique").starts_with("slb") && !is_published(row);
  });
}

std::vector<bool> on_front(const std::vector<Row>& rows) {
  std::map<std::string, std::vector<std::size_t>> scenes;
  for (std::size_t i = 0; i < rows.size(); ++i) scenes[rows[i].scene].push_back(i);
  std::vector<bool> on(rows.size(), false);
  for (const auto& [scene, members] : scenes) {
    std::vector<const char*> names{"errors.fixed.border_voxels", "memory.format_bits"};
    if (std::ranges::any_of(members, [&](std::size_t i) { return has(rows[i], kArea); }))
      names.push_back(kArea);
    std::vector<std::vector<double>> objectives;
    for (const std::size_t i : members) objectives.push_back(objectives_of(rows[i], names));
    const std::vector<bool> front = pareto_front(objectives);
    for (std::size_t k = 0; k < members.size(); ++k) on[members[k]] = front[k];
  }
  return on;
}

std::string csv_table(const std::vector<Row>& rows) {
  const std::vector<Varied> varied = varied_parameters(rows);
  std::set<std::string> figures;
  for (const Row& row : rows) {
    for (const auto& [name, value] : row.figures) figures.insert(name);
  }
  const std::vector<bool> front = on_front(rows);
  std::vector<std::string> header{"scene", "front"};
  for (const Varied& parameter : varied) header.push_back(parameter.key);
  header.insert(header.end(), figures.begin(), figures.end());
  header.emplace_back("command");
  std::string text = line_of(header);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (row.failed()) continue;
    std::vector<std::string> cells{row.scene, front[i] ? "1" : "0"};
    for (const Varied& parameter : varied) cells.push_back(parameter_text(row, parameter.key));
    for (const std::string& name : figures) {
      const auto figure = row.figures.find(name);
      cells.push_back(figure == row.figures.end() ? std::string() : fmt::format("{}", figure->second));
    }
    cells.push_back(fmt::format("gnomon run {}", row.flags));
    text += line_of(cells);
  }
  return text;
}

}  // namespace gnomon::sweep
