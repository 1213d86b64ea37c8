// SPDX-License-Identifier: Apache-2.0
// A unit with more ports than a package has pins, between shift registers. Theory: docs/area.md, "Clock".
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/area/units.hpp"

namespace gnomon::area {

struct Port {
  std::string name;
  int width = 1;  ///< bits
  bool input = true;
};

/// The ports of `module` in what Yosys' write_json says.
std::vector<Port> ports_of(const nlohmann::json& design, const std::string& module);

/// Module area_wrapper in Verilog: clock, a bit in, load, a bit out. All of the unit's inputs come from
/// registers and all of its outputs go to registers, so that its own paths decide the clock.
std::string wrapper(const Unit& unit, const std::vector<Port>& ports);

}  // namespace gnomon::area
