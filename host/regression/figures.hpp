// SPDX-License-Identifier: Apache-2.0
// What a run of a scene is remembered by. Theory: docs/verification.md, "Regression".
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

namespace gnomon::regression {

/// By name ("slb.cycles.FILL"): an integer, a number, a text (a hash) or null (a figure without a value).
using Figures = std::map<std::string, nlohmann::json>;

/// From what metrics.json holds, for each technique T: T.words and T.results (how many result words, and
/// their hash: `results`, one for each technique, in order), T.cycles.PASS (but IDLE, which is the driver's
/// doing), T.error.*. Throws std::invalid_argument where `results` has not one hash a technique.
Figures figures_of(const nlohmann::ordered_json& metrics, std::span<const std::string> results);

}  // namespace gnomon::regression
