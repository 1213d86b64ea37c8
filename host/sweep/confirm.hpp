// SPDX-License-Identifier: Apache-2.0
// How predicted cycles compare with the hardware's. Theory: docs/sweep.md, "Confirming".
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "host/report/run_record.hpp"
#include "host/sweep/measurement.hpp"

namespace gnomon::sweep {

/// Cycles by "cycles.PASS.CAUSE", as golden::Counters has them.
using Cycles = std::map<std::string, std::uint64_t>;

/// The label that tells how a point was confirmed: "agrees", or why not.
inline constexpr std::string_view kConfirmLabel = "confirmed";
inline constexpr std::string_view kAgrees = "agrees";

/// Cycles of all passes together that model and hardware may differ by, as a share of the hardware's. On the
/// chip the model is exact but for what its page says.
inline constexpr double kCycleBound = 0.001;

/// Figures "NAME.cycles" (all passes that decide shadows) and "NAME.cycles.PASS" of what took any.
std::map<std::string, double> cycle_figures(const std::string& name, const Cycles& cycles);

/// What is stored of a point that ran on the hardware: "rtl.cycles...", "confirm.words", "confirm.differing",
/// "confirm.cycle_error" (the passes' differences added up, as a share of "rtl.cycles"), and the label.
Measurement confirmation(const Cycles& model, const Cycles& rtl, const report::CompareRecord& compare);

}  // namespace gnomon::sweep
