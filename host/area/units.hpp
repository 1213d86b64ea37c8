// SPDX-License-Identifier: Apache-2.0
// The datapaths whose cells are counted, and what a configuration makes of them. Theory: docs/area.md.
#pragma once

#include <gnomon/golden/config.hpp>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::area {

/// A module by itself, with the parameters that its surroundings give it.
struct Unit {
  std::string module;  ///< in a file of this name
  int count = 1;       ///< how many of it there are
  std::vector<std::pair<std::string, int>> parameters;
};

/// Of the units that the configuration has, in the order of the data. Memories are not among them.
std::vector<Unit> units_of(const golden::HardwareConfig& config);

}  // namespace gnomon::area
