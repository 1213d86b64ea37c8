// SPDX-License-Identifier: Apache-2.0
// Two sets of figures, side by side.
#include "host/regression/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace gnomon::regression {
namespace {

constexpr double kTolerance = 1e-9;

bool same(const nlohmann::json& a, const nlohmann::json& b) {
  if (!a.is_number_float() && !b.is_number_float()) return a == b;
  if (!a.is_number() || !b.is_number()) return false;
  const double x = a.get<double>(), y = b.get<double>();
  return std::abs(x - y) <= kTolerance * std::max(std::abs(x), std::abs(y));
}

nlohmann::json value_of(const Figures& figures, const std::string& name) {
  const auto at = figures.find(name);
  return at == figures.end() ? nlohmann::json() : at->second;
}

std::string text_of(const nlohmann::json& value) {
  if (value.is_null()) return "nothing";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

Comparison compare(const Figures& was, const Figures& is) {
  std::set<std::string> names;
  for (const auto& [name, value] : was) names.insert(name);
  for (const auto& [name, value] : is) names.insert(name);
  Comparison comparison;
  comparison.compared = names.size();
  for (const std::string& name : names) {
    const Difference difference{name, value_of(was, name), value_of(is, name)};
    if (!same(difference.was, difference.is) || was.contains(name) != is.contains(name))
      comparison.differences.push_back(difference);
  }
  return comparison;
}

std::string to_text(const Difference& difference) {
  return fmt::format("{}: was {}, is {}", difference.figure, text_of(difference.was), text_of(difference.is));
}

}  // namespace gnomon::regression
