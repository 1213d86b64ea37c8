// SPDX-License-Identifier: Apache-2.0
// What `gnomon slb` works on: its files, its parameters, the hardware they ask for.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/config/settings.hpp"
#include "host/slb/engine_run.hpp"
#include "host/slb/fixed_point.hpp"
#include "sim/model_cache.hpp"

namespace gnomon::cli {

struct SlbJob {
  std::filesystem::path loops_file;
  config::Settings settings;
  golden::HardwareConfig config;
  slb::LoopScene scene;
  std::vector<slb::FixedCaster> casters;
  std::vector<slb::Receiver> receivers;  ///< empty without a file of queries
};

/// Reads the files (`queries` may be empty) and finds the hardware: the plane that the parameters name, or
/// the smallest that holds every vertex. Warns of what was ignored and of what casts nothing, unless it
/// fails.
Result<SlbJob> slb_job(const Context& context, const std::filesystem::path& loops,
                       const std::filesystem::path& queries, const std::vector<std::string>& set_flags);

/// "plane=64 frac_bits=7 ...": the configuration that stands next to every figure.
std::string slb_configuration(const golden::HardwareConfig& config);

/// Runs streams on golden, or with a cache on the hardware compared with golden, with progress on a
/// terminal. `context`, `settings` and `cache` must outlive it. Throws Interrupted, sim::Aborted.
slb::Runner slb_runner(Context& context, const config::Settings& settings,
                       const std::vector<std::string>& defines, sim::ModelCache* cache);

}  // namespace gnomon::cli
