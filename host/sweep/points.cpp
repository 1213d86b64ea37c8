// SPDX-License-Identifier: Apache-2.0
// Points of a sweep.
#include "host/sweep/points.hpp"

#include <fmt/format.h>

#include <set>

#include "host/sweep/sample.hpp"

namespace gnomon::sweep {
namespace {

constexpr std::size_t kMostCombinations = 10000000;

std::vector<std::size_t> sizes(const std::vector<Axis>& axes) {
  std::vector<std::size_t> sizes;
  sizes.reserve(axes.size());
  for (const Axis& axis : axes) sizes.push_back(axis.values.size());
  return sizes;
}

Result<std::vector<Combination>> combinations(const Spec& spec) {
  if (spec.axes.empty()) return {};
  const std::vector<std::size_t> values = sizes(spec.axes);
  switch (spec.sample.method) {
    case Method::Random:
      return random_sample(values, spec.sample.points, spec.sample.seed);
    case Method::LatinHypercube:
      return latin_hypercube(values, spec.sample.points, spec.sample.seed);
    case Method::Grid:
      break;
  }
  const std::size_t size = grid_size(values);
  if (size > kMostCombinations)
    return fail(fmt::format("{}: error: the axes make more than {} combinations, expected a [sample]",
                            spec.name, kMostCombinations));
  return grid(values);
}

std::vector<config::Assignment> assignments_of(const Spec& spec, const Assignments& own) {
  Assignments all = own;
  all.insert(spec.fixed.begin(), spec.fixed.end());  // what a point sets itself stays
  std::vector<config::Assignment> assignments;
  for (const auto& [key, text] : all) assignments.push_back({key, text, spec.name});
  return assignments;
}

/// Every value, so that two points are told apart exactly where their hardware or work could differ.
std::string signature(const config::Settings& settings) {
  std::string text;
  for (const config::Parameter& parameter : config::parameters())
    text += config::to_text(settings.entry(parameter.key).value) + '\n';
  return text;
}

class Expansion {
 public:
  Expansion(const Spec& spec, std::vector<Constraint> constraints)
      : spec_(spec), constraints_(std::move(constraints)) {}

  /// The points of one scene.
  Result<void> add(std::size_t scene, const std::vector<config::Assignment>& parameters,
                   std::span<const Assignments> all) {
    std::set<std::string> seen;
    for (const Assignments& own : all) {
      const std::vector<std::vector<config::Assignment>> sources{parameters, assignments_of(spec_, own)};
      auto settings = config::Settings::resolve(sources);
      if (!settings) return tl::make_unexpected(settings.error());
      if (!allowed(*settings) || !seen.insert(signature(*settings)).second) continue;
      points_.push_back({scene, std::move(*settings)});
    }
    return {};
  }

  std::vector<Point> take() { return std::move(points_); }

 private:
  bool allowed(const config::Settings& settings) {
    for (Constraint& constraint : constraints_) {
      if (!constraint.holds(settings)) return false;
    }
    return true;
  }

  const Spec& spec_;
  std::vector<Constraint> constraints_;
  std::vector<Point> points_;
};

}  // namespace

Result<std::vector<Point>> expand(const Spec& spec,
                                  std::span<const std::vector<config::Assignment>> scene_parameters) {
  std::vector<Constraint> constraints;
  for (const std::string& text : spec.constraints) {
    Result<Constraint> constraint = Constraint::parse(text);
    if (!constraint) return tl::make_unexpected(constraint.error());
    constraints.push_back(std::move(*constraint));
  }
  const auto taken = combinations(spec);
  if (!taken) return tl::make_unexpected(taken.error());
  std::vector<Assignments> all;
  for (const Combination& combination : *taken) {
    Assignments own;
    for (std::size_t axis = 0; axis < spec.axes.size(); ++axis)
      own.emplace(spec.axes[axis].key, spec.axes[axis].values[combination[axis]]);
    all.push_back(std::move(own));
  }
  all.insert(all.end(), spec.list.begin(), spec.list.end());

  Expansion expansion(spec, std::move(constraints));
  for (std::size_t scene = 0; scene < spec.scenes.size(); ++scene) {
    if (auto done = expansion.add(scene, scene_parameters[scene], all); !done)
      return tl::make_unexpected(done.error());
  }
  std::vector<Point> points = expansion.take();
  if (points.empty()) return fail(spec.name + ": error: no combination holds all constraints");
  return points;
}

}  // namespace gnomon::sweep
