// SPDX-License-Identifier: Apache-2.0
// How predicted cycles compare with the hardware's.
#include "host/sweep/confirm.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace gnomon::sweep {
namespace {

constexpr std::string_view kPrefix = "cycles.";

/// READ shows what memory holds and decides nothing; IDLE is nobody's work.
bool decides_shadows(const std::string& pass) {
  return pass != "READ" && pass != "IDLE";
}

std::map<std::string, double> by_pass(const Cycles& cycles) {
  std::map<std::string, double> passes;
  for (const auto& [name, count] : cycles) {
    if (!name.starts_with(kPrefix)) continue;
    const std::string pass = name.substr(kPrefix.size(), name.rfind('.') - kPrefix.size());
    if (decides_shadows(pass)) passes[pass] += static_cast<double>(count);
  }
  return passes;
}

std::string verdict_of(const report::CompareRecord& compare, double error, double bound) {
  if (compare.failed()) return "flagged: " + report::verdict(compare);
  if (error > bound)
    return fmt::format("flagged: predicted cycles are off by {:.2f} %, more than {:.1f} %", 100 * error,
                       100 * bound);
  return std::string(kAgrees);
}

}  // namespace

std::map<std::string, double> cycle_figures(const std::string& name, const Cycles& cycles) {
  const std::string total = name + ".cycles", prefix = total + ".";
  std::map<std::string, double> figures;
  double sum = 0;
  for (const auto& [pass, count] : by_pass(cycles)) {
    sum += count;
    if (count > 0) figures.emplace(prefix + pass, count);
  }
  if (sum > 0) figures.emplace(total, sum);
  return figures;
}

Measurement confirmation(const Cycles& model, const Cycles& rtl, const report::CompareRecord& compare,
                         double bound) {
  Measurement measured;
  measured.figures = cycle_figures("rtl", rtl);
  std::map<std::string, double> predicted = by_pass(model);
  double apart = 0, all = 0;
  for (const auto& [pass, count] : by_pass(rtl)) {
    apart += std::abs(count - std::exchange(predicted[pass], 0));
    all += count;
  }
  for (const auto& [pass, count] : predicted) apart += count;  // passes that the hardware does not have
  const double error = all > 0 ? apart / all : apart > 0 ? 1 : 0;
  measured.figures["confirm.cycle_error"] = error;
  measured.figures["confirm.words"] = static_cast<double>(compare.words);
  measured.figures["confirm.differing"] = static_cast<double>(compare.differing + compare.other_faults);
  measured.labels.emplace(kConfirmLabel, verdict_of(compare, error, bound));
  return measured;
}

bool is_flagged(const Measurement& measured) {
  const auto label = measured.labels.find(std::string(kConfirmLabel));
  return label != measured.labels.end() && label->second != kAgrees;
}

}  // namespace gnomon::sweep
