// SPDX-License-Identifier: Apache-2.0
// A point's cells and clock as figures. Theory: docs/sweep.md, "Area".
#pragma once

#include <map>
#include <optional>
#include <string>

#include "host/area/area.hpp"

namespace gnomon::sweep {

/// "area.luts", "area.carries", "area.flip_flops", "area.dsps", "area.rams"; and where every unit has a
/// clock "area.clock_mhz" (the lowest of their medians), "area.period_ns", and with `cycles` "area.seconds",
/// which they take at that clock.
std::map<std::string, double> area_figures(const area::Area& area, std::optional<double> cycles);

}  // namespace gnomon::sweep
