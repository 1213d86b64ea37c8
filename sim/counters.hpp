// SPDX-License-Identifier: Apache-2.0
// All counters of a build, from whoever can read one of them.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <string>

namespace gnomon::sim {

/// `counter(index)` reads one (rtl/README.md, "Counter indices"); those of units that `config` leaves out are
/// not asked for.
golden::Counters read_counters(const golden::HardwareConfig& config,
                               const std::function<std::uint64_t(std::uint32_t index)>& counter);

/// Those of the caches (docs/cache.md), by the names of sim/counter_names.hpp: of the memories that were
/// used.
std::map<std::string, std::uint64_t> read_cache_counters(
    const std::function<std::uint64_t(std::uint32_t index)>& counter);

/// What `now` has counted since `before`.
golden::Counters operator-(golden::Counters now, const golden::Counters& before);

}  // namespace gnomon::sim
