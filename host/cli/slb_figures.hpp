// SPDX-License-Identifier: Apache-2.0
// What `gnomon slb` says about a run.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host/cli/slb_job.hpp"

namespace gnomon::cli {

/// Keys as in docs/slb-cli.md, "Figures".
nlohmann::ordered_json slb_figures(const SlbJob& job, const slb::EngineRun& run, double seconds);

/// The same for a person, a few lines.
std::string slb_summary(const nlohmann::ordered_json& figures);

}  // namespace gnomon::cli
