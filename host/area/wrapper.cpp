// SPDX-License-Identifier: Apache-2.0
// Shift in, load, shift out.
#include "host/area/wrapper.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gnomon::area {
namespace {

constexpr const char* kClock = "clk_i";

int bits_of(const std::vector<Port>& ports, bool input) {
  int bits = 0;
  for (const Port& port : ports) bits += port.input == input && port.name != kClock ? port.width : 0;
  return bits;
}

std::string parameters_of(const Unit& unit) {
  std::vector<std::string> settings;
  settings.reserve(unit.parameters.size());
  for (const auto& [name, value] : unit.parameters) settings.push_back(fmt::format(".{}({})", name, value));
  return settings.empty() ? std::string() : fmt::format("#({}) ", fmt::join(settings, ", "));
}

std::string connections_of(const std::vector<Port>& ports) {
  std::vector<std::string> all;
  int in = 0, out = 0;
  for (const Port& port : ports) {
    if (port.name == kClock) {
      all.push_back(fmt::format(".{}(clk_i)", kClock));
      continue;
    }
    int& at = port.input ? in : out;
    all.push_back(
        fmt::format(".{}({}[{}:{}])", port.name, port.input ? "in_q" : "out", at + port.width - 1, at));
    at += port.width;
  }
  return fmt::format("{}", fmt::join(all, ",\n    "));
}

}  // namespace

std::vector<Port> ports_of(const nlohmann::json& design, const std::string& module) {
  std::vector<Port> ports;
  for (const auto& [name, port] : design.at("modules").at(module).at("ports").items())
    ports.push_back({name, static_cast<int>(port.at("bits").size()), port.at("direction") == "input"});
  return ports;
}

std::string wrapper(const Unit& unit, const std::vector<Port>& ports) {
  // A bit more than there is, so that a range is never empty.
  const int in = bits_of(ports, true) + 1, out = bits_of(ports, false) + 1;
  return fmt::format(R"(module area_wrapper(input clk_i, input serial_i, input load_i, output serial_o);
  reg [{0}:0] in_q;
  reg [{1}:0] out_q;
  wire [{1}:0] out;
  always @(posedge clk_i) begin
    in_q <= {{in_q[{2}:0], serial_i}};
    out_q <= load_i ? out : {{out_q[{3}:0], in_q[{0}]}};
  end
  assign serial_o = out_q[{1}];
  assign out[{1}] = 1'b0;
  {4} {5}u_unit (
    {6}
  );
endmodule
)",
                     in - 1, out - 1, in - 2, out - 2, unit.module, parameters_of(unit),
                     connections_of(ports));
}

}  // namespace gnomon::area
