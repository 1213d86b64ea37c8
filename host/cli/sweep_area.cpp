// SPDX-License-Identifier: Apache-2.0
// Every unit that some point has is estimated once, whatever number of points have it.
#include "host/cli/sweep_area.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "host/cli/area_hardware.hpp"
#include "host/cli/progress.hpp"
#include "host/sweep/area_figures.hpp"

namespace gnomon::cli {
namespace {

/// What makes two units the same.
std::string name_of(const area::Unit& unit) {
  std::string name = unit.module;
  for (const auto& [parameter, value] : unit.parameters) name += fmt::format(" {}={}", parameter, value);
  return name;
}

/// Units by name; nothing where the estimate is still to be made.
using Estimates = std::map<std::string, std::optional<area::UnitEstimate>>;

class Estimation {
 public:
  Estimation(Context& context, int seeds, unsigned jobs) : context_(context), seeds_(seeds), jobs_(jobs) {}

  /// Takes note of a point's units.
  void need(const std::vector<area::Unit>& units) {
    for (const area::Unit& unit : units) {
      if (estimates_.try_emplace(name_of(unit)).second) open_.push_back(unit);
    }
  }

  Result<void> run() {
    tbb::task_arena arena(jobs_ > 0 ? static_cast<int>(jobs_) : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for_each(open_, [&](const area::Unit& unit) { take(unit); }); });
    if (context_.interruption.flag().load()) throw Interrupted();
    if (error_) return tl::make_unexpected(*error_);
    return {};
  }

  area::Area of(const std::vector<area::Unit>& units) const {
    area::Area area;
    for (const area::Unit& unit : units) {
      area::UnitEstimate estimate = *estimates_.at(name_of(unit));
      estimate.unit = unit;  // how many there are is the point's
      area.add(std::move(estimate));
    }
    return area;
  }

  std::size_t units() const { return estimates_.size(); }
  int runs() const { return estimator_.runs(); }

 private:
  void take(const area::Unit& unit) {
    {
      const std::scoped_lock lock(mutex_);
      if (error_ || context_.interruption.flag().load()) return;
    }
    auto estimate = estimator_.estimate(unit, seeds_);
    const std::scoped_lock lock(mutex_);
    line_.update("area", static_cast<double>(++taken_) / static_cast<double>(open_.size()));
    if (estimate) {
      estimates_.at(name_of(unit)) = std::move(*estimate);
    } else if (!error_) {
      error_ = estimate.error();
    }
  }

  Context& context_;
  int seeds_;
  unsigned jobs_;
  area::Estimator estimator_;
  std::mutex mutex_;
  ProgressLine line_{context_.show_progress};
  std::vector<area::Unit> open_;
  std::size_t taken_ = 0;
  std::optional<Error> error_;
  Estimates estimates_;
};

std::optional<double> cycles_of(const sweep::Row& row) {
  const auto figure = row.figures.find("model.cycles");
  return figure == row.figures.end() ? std::nullopt : std::optional(figure->second);
}

}  // namespace

void SweepArea::add_to(CLI::App& command, const std::vector<CLI::Option*>& others) {
  CLI::Option* area = command.add_flag("--area", asked_, "Estimate cells of each point's datapaths too");
  for (CLI::Option* other : others) area->excludes(other);
  command.add_option("--seeds", seeds_, "With --area: place each unit so often, for a clock; 0: cells alone")
      ->check(CLI::Range(0, 100))
      ->needs(area)
      ->capture_default_str();
}

Result<SweepArea::Counts> SweepArea::run(Context& context, const std::vector<sweep::Task>& tasks,
                                         sweep::Store& store, unsigned jobs) const {
  std::map<std::string, std::optional<double>> cycles;  // of done points
  for (const sweep::Row& row : store.rows()) {
    if (!row.failed()) cycles.emplace(row.key, cycles_of(row));
  }
  Estimation estimation(context, seeds_, jobs);
  std::map<std::string, std::vector<area::Unit>> units;
  for (const sweep::Task& task : tasks) {
    if (!cycles.contains(task.key)) continue;
    const config::Settings& settings = task.point.settings;
    const auto hardware = area_hardware(settings, settings.words("technique").front());
    if (!hardware) {  // legal only as the scene makes it
      store.amend(task.key, {}, {{"area.none", hardware.error().message}}, "area.");
      continue;
    }
    std::vector<area::Unit> own = area::units_of(*hardware);
    if (own.empty()) continue;
    estimation.need(own);
    units.emplace(task.key, std::move(own));
  }
  if (auto done = estimation.run(); !done) return tl::make_unexpected(done.error());
  for (const auto& [key, own] : units)
    store.amend(key, sweep::area_figures(estimation.of(own), cycles.at(key)), {}, "area.");
  return Counts{units.size(), estimation.units(), estimation.runs()};
}

}  // namespace gnomon::cli
