// SPDX-License-Identifier: Apache-2.0
// How long FILL of one object takes (docs/cycle-model.md, "Fill").
#pragma once

#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/slb/model.hpp>

#include "run.hpp"

namespace gnomon::golden::cycles {

struct FillCycles {
  Cycle steps = 0;  ///< cycles in which something is decided
  Cycle idle = 0;   ///< the unit is idle in the cycle with this number after the header's
};

/// `flat`: the object has one depth.
FillCycles fill_cycles(const slb::FillSweep& sweep, bool flat, const slb::SlbConfig& config,
                       const HardwareTiming& timing);

}  // namespace gnomon::golden::cycles
