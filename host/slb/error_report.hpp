// SPDX-License-Identifier: Apache-2.0
// The buffer's error for several widths, next to shadow maps, with memory and cycles of each
// (docs/slb-cli.md, "Error report").
#pragma once

#include <gnomon/golden/config.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/slb/border_samples.hpp"
#include "host/slb/costs.hpp"
#include "host/slb/engine_run.hpp"

namespace gnomon::slb {

/// One width of the buffer.
struct ErrorPoint {
  golden::HardwareConfig config;
  Displacement displacement;
  Costs buffer, plain_map, fine_map;
  EngineRun run;                            ///< its results are dropped
  std::vector<golden::slb::Entry> entries;  ///< the whole plane, for pictures
};

/// Draws the casters, asks samples behind all of them and compares with exact polygons. Fails where a vertex
/// lies outside the guard band.
Result<ErrorPoint> measure_error(const LoopScene& scene, const golden::HardwareConfig& config,
                                 const SampleOptions& options, const Runner& runner);

/// Fraction bits 3..8 with as many more slope bits as `config` has, the rest as in `config`; vertices and
/// queries get the fraction bits that they need. What is no legal hardware is left out.
std::vector<golden::HardwareConfig> report_configurations(const golden::HardwareConfig& config);

/// The figures, keys as in docs/slb-cli.md.
nlohmann::ordered_json to_json(const ErrorPoint& point);

}  // namespace gnomon::slb
