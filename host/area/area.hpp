// SPDX-License-Identifier: Apache-2.0
// All datapaths of a configuration together. Theory: docs/area.md.
#pragma once

#include <optional>
#include <vector>

#include "host/area/estimate.hpp"

namespace gnomon::area {

struct Area {
  std::vector<UnitEstimate> units;
  Cells sum;  ///< of all units, each as often as it is there

  /// Adds a unit, `count` times.
  void add(UnitEstimate unit);
  /// The lowest of the units' median clocks, which the whole cannot exceed; nothing where no unit has one.
  std::optional<double> clock_mhz() const;
  /// Every unit has a clock: none is larger than the device, and clocks were asked for.
  bool all_placed() const;
};

}  // namespace gnomon::area
