// SPDX-License-Identifier: Apache-2.0
// The report's plots as files.
#include "host/sweep/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "host/sweep/chart.hpp"
#include "host/sweep/figures.hpp"
#include "host/sweep/front.hpp"
#include "sim/process.hpp"

namespace gnomon::sweep {
namespace {

constexpr const char* kError = "errors.fixed.border_voxels";
/// Growth is told where theory tells it: in the plane's pixels, where nothing but the buffer's own errors
/// are.
constexpr const char* kGrowingError = "errors.fixed.ground.boundary_displacement";
constexpr std::array<const char*, 10> kCosts{
    "memory.format_bits", "memory.hardware_bits", "model.cycles", "rtl.cycles",     "system.cycles",
    "seconds.golden",     "seconds.rtl",          "area.luts",    "area.period_ns", "area.seconds"};
constexpr std::array<const char*, 3> kGrowth{"frac_bits", "slope_bits", "frags"};

std::optional<double> figure(const Row& row, const std::string& name) {
  const auto found = row.figures.find(name);
  return found == row.figures.end() ? std::nullopt : std::optional(found->second);
}

std::string label_of(const std::string& name) {
  for (const Figure& figure : plotted_figures()) {
    if (figure.name == name) return std::string(figure.label);
  }
  return name;
}

/// A scene's done points with what tells them apart.
class ScenePlots {
 public:
  ScenePlots(std::string scene, std::vector<Row> rows)
      : scene_(std::move(scene)), rows_(std::move(rows)), varied_(varied_parameters(rows_)) {}

  std::vector<Plot> all() const {
    std::vector<Plot> plots;
    for (const std::string cost : kCosts) {
      if (auto svg = scatter(cost); !svg.empty()) plots.push_back({name("error-" + cost), std::move(svg)});
    }
    for (const std::string key : kGrowth) {
      if (auto svg = growth(key); !svg.empty()) plots.push_back({name("error-" + key), std::move(svg)});
    }
    return plots;
  }

 private:
  std::string name(std::string what) const {
    std::ranges::replace(what, '.', '-');
    return std::filesystem::path(scene_).stem().string() + "-" + what;
  }

  const Varied* varied(const std::string& key) const {
    const auto found = std::ranges::find(varied_, key, &Varied::key);
    return found == varied_.end() ? nullptr : &*found;
  }

  /// What colours tell apart: the first of these that varies, `besides` left out.
  const Varied* colours(const std::string& besides) const {
    for (const char* key : {"technique", "frac_bits", "slope_bits"}) {
      if (key != besides && varied(key) != nullptr) return varied(key);
    }
    return nullptr;
  }

  static std::size_t series(const Varied* by, const Row& row) {
    if (by == nullptr) return 0;
    return static_cast<std::size_t>(std::ranges::find(by->values, parameter_text(row, by->key)) -
                                    by->values.begin());
  }

  static void name_series(Chart& chart, const Varied* by) {
    if (by == nullptr) return;
    for (std::size_t i = 0; i < by->values.size(); ++i)
      chart.legend(i, (by->key == "technique" ? "" : by->key + " ") + by->values[i]);
  }

  std::string scatter(const std::string& cost) const {
    std::vector<const Row*> shown;
    std::vector<double> xs, ys;
    std::vector<std::pair<double, double>> points;
    for (const Row& row : rows_) {
      const auto x = figure(row, cost), y = figure(row, kError);
      if (!x || !y) continue;
      shown.push_back(&row);
      points.emplace_back(*x, *y);
      xs.push_back(*x);
      ys.push_back(*y);
    }
    if (points.size() < 2) return "";
    Chart chart(Scale(xs), Scale(ys), label_of(cost), label_of(kError));
    const std::vector<bool> front = front_of(points);
    const Varied* by = colours("");
    const bool marks = marks_published(rows_);
    std::vector<std::pair<double, double>> steps;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      chart.point(points[i].first, points[i].second, series(by, *shown[i]), !front[i],
                  marks && is_published(*shown[i]));
      if (front[i]) steps.push_back(points[i]);
    }
    std::ranges::sort(steps);
    chart.steps(steps);
    name_series(chart, by);
    chart.note("line: Pareto front");
    if (marks && std::ranges::any_of(shown, [](const Row* row) { return is_published(*row); }))
      chart.note("ringed: published");
    return chart.svg(scene_ + ": error against " + label_of(cost));
  }

  static std::vector<bool> front_of(const std::vector<std::pair<double, double>>& points) {
    std::vector<std::vector<double>> objectives;
    objectives.reserve(points.size());
    for (const auto& [x, y] : points) objectives.push_back({x, y});
    return pareto_front(objectives);
  }

  /// Geometric means of the error, a curve for each colour; for F the halving with each bit beside them.
  std::string growth(const std::string& key) const {
    const Varied* axis = varied(key);
    if (axis == nullptr) return "";
    const Varied* by = colours(key);
    std::map<std::size_t, std::map<double, std::pair<double, int>>> sums;  // of logarithms, and how many
    std::vector<double> xs, ys;
    for (const Row& row : rows_) {
      const auto error = figure(row, kGrowingError);
      if (!error || *error <= 0) continue;
      auto& [sum, count] = sums[series(by, row)][std::stod(parameter_text(row, key))];
      sum += std::log(*error);
      ++count;
    }
    std::map<std::size_t, Chart::Points> curves;
    for (const auto& [which, values] : sums)
      for (const auto& [x, mean] : values) {
        curves[which].emplace_back(x, std::exp(mean.first / mean.second));
        xs.push_back(x);
        ys.push_back(curves[which].back().second);
      }
    if (xs.empty()) return "";
    Chart chart(Scale(xs, Scale::Kind::Whole), Scale(ys, Scale::Kind::Logarithmic), key,
                label_of(kGrowingError));
    for (const auto& [which, points] : curves) chart.line(points, which);
    name_series(chart, by);
    if (key == "frac_bits") {
      const auto [first, last] = std::ranges::minmax(xs);
      Chart::Points halving;
      const double top = *std::ranges::max_element(ys), bottom = *std::ranges::min_element(ys);
      for (double f = first; f <= last && top * std::exp2(first - f) >= bottom; ++f)
        halving.emplace_back(f, top * std::exp2(first - f));
      chart.dashed(halving);
      chart.note("dashed: halved a bit");
    }
    return chart.svg(scene_ + ": how the error grows with " + key);
  }

  std::string scene_;
  std::vector<Row> rows_;
  std::vector<Varied> varied_;
};

Result<void> write_file(const std::filesystem::path& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) return fail(path.string() + ": error: cannot be written");
  return {};
}

bool convert(const std::filesystem::path& folder, const std::string& name) try {
  sim::Process process({"rsvg-convert", "--zoom=2", "-o", name + ".png", name + ".svg"}, folder, "/dev/null");
  return process.succeeded();
} catch (const std::runtime_error&) {
  return false;
}

}  // namespace

std::vector<Plot> plots_of(const std::vector<Row>& rows) {
  std::map<std::string, std::vector<Row>> scenes;
  for (const Row& row : rows) {
    if (!row.failed()) scenes[row.scene].push_back(row);
  }
  std::vector<Plot> plots;
  for (auto& [scene, members] : scenes) {
    for (Plot& plot : ScenePlots(scene, std::move(members)).all()) plots.push_back(std::move(plot));
  }
  return plots;
}

Result<bool> write_plots(const std::vector<Plot>& plots, const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) return fail(fmt::format("{}: cannot be made: {}", folder.string(), problem.message()));
  bool drawn = true;
  for (const Plot& plot : plots) {
    if (auto done = write_file(folder / (plot.name + ".svg"), plot.svg); !done)
      return tl::make_unexpected(done.error());
    drawn = drawn && convert(folder, plot.name);
  }
  return drawn;
}

}  // namespace gnomon::sweep
