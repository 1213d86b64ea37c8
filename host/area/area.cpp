// SPDX-License-Identifier: Apache-2.0
// Sums and bounds over units.
#include "host/area/area.hpp"

#include <algorithm>
#include <utility>

namespace gnomon::area {
namespace {

bool placed(const UnitEstimate& unit) {
  return unit.clock && unit.clock->fits();
}

}  // namespace

void Area::add(UnitEstimate unit) {
  sum += unit.cells * static_cast<std::uint64_t>(unit.unit.count);
  units.push_back(std::move(unit));
}

std::optional<double> Area::clock_mhz() const {
  std::optional<double> lowest;
  for (const UnitEstimate& unit : units) {
    if (placed(unit)) lowest = std::min(lowest.value_or(unit.clock->median()), unit.clock->median());
  }
  return lowest;
}

bool Area::all_placed() const {
  return !units.empty() && std::ranges::all_of(units, placed);
}

}  // namespace gnomon::area
