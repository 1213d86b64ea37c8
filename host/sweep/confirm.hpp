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

/// Cycles of all passes together that model and hardware may differ by, as a share of the hardware's. With
/// everything on the chip the model is exact but for what its page says; within the system it leaves out the
/// processor.
inline constexpr double kChipBound = 0.001, kSystemBound = 0.01;

/// Figures "NAME.cycles" (all passes that decide shadows) and "NAME.cycles.PASS" of what took any.
std::map<std::string, double> cycle_figures(const std::string& name, const Cycles& cycles);

/// What is stored of a point that ran on the hardware: "rtl.cycles...", "confirm.words", "confirm.differing",
/// "confirm.cycle_error" (the passes' differences added up, as a share of "rtl.cycles"), and the label, which
/// flags a point whose error is above `bound`.
Measurement confirmation(const Cycles& model, const Cycles& rtl, const report::CompareRecord& compare,
                         double bound);

/// The point ran on the hardware, and does not agree.
bool is_flagged(const Measurement& measured);

}  // namespace gnomon::sweep
