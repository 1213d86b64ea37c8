// SPDX-License-Identifier: Apache-2.0
// What the buffer and a shadow map cost: memory and cycles (docs/error-metrics.md, "Costs").
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>

namespace gnomon::slb {

struct Costs {
  std::uint64_t memory_bits = 0;
  double draw_cycles = 0;   ///< clearing and drawing all casters
  double query_cycles = 0;  ///< answering all queries
  bool measured = false;    ///< by the hardware; else the documented steady state
};

/// Of the buffer, from what a stream came to: the hardware's cycles where there are, else its documented
/// steady state.
Costs buffer_costs(const golden::HardwareConfig& config, const golden::Counters& counters);

/// Of a shadow map with `finer` times the plane's pixels a side that draws the same casters and answers the
/// same queries. 32-bit texels, 16 a cycle.
Costs map_costs(const golden::HardwareConfig& config, const golden::Counters& counters, int finer);

}  // namespace gnomon::slb
