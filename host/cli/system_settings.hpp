// SPDX-License-Identifier: Apache-2.0
// The parameters of the simulated system.
#pragma once

#include "host/config/settings.hpp"
#include "sim/system/system_engine.hpp"

namespace gnomon::cli {

/// All but `rtl`.
sim::system::SystemOptions system_settings(const config::Settings& settings);
/// Somebody has set a parameter of the bus, the caches or the DRAM.
bool gives_memory(const config::Settings& settings);

}  // namespace gnomon::cli
