// SPDX-License-Identifier: Apache-2.0
// metrics.json: every figure of a run, with the whole configuration. Keys, units and meanings:
// docs/report.md.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "host/report/run_record.hpp"

namespace gnomon::report {

/// Grows whenever a key changes its meaning or goes; new keys leave it alone.
inline constexpr int kMetricsSchema = 1;

/// Stages whose time stands for a figure elsewhere in the report.
inline constexpr std::string_view kGoldenStage = "golden engine";
inline constexpr std::string_view kRtlStage = "rtl engine";
inline constexpr std::string_view kSystemStage = "system engine";
inline constexpr std::string_view kSoftwareStage = "software technique";
inline constexpr std::string_view kDoubleStage = "double reference";
inline constexpr std::string_view kExactStage = "exact reference";
inline constexpr std::string_view kShadowMapStage = "shadow maps";
inline constexpr std::string_view kFramesStage = "frames";

/// Of the engine under test, "rtl" or "system".
inline std::string_view engine_stage(std::string_view engine) {
  return engine == "system" ? kSystemStage : kRtlStage;
}

nlohmann::ordered_json metrics_json(const RunRecord& record);
/// Of several techniques over one scene, at least one: the first one's figures, and in `techniques` those of
/// each.
nlohmann::ordered_json metrics_json(std::span<const RunRecord> records);

}  // namespace gnomon::report
