// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/topology/outcome.hpp"

#include <stdexcept>

namespace gnomon::rtl_test::topology {

Outcome expected(std::span<const Command> program, const TopologyConfig& config) {
  golden::topology::TopologyUnit unit(config);
  Outcome outcome;
  for (const Command& command : program) {
    if (command.sets_registers) {
      unit.set_registers(command.registers);
      continue;
    }
    const auto answer =
        unit.execute(static_cast<std::uint8_t>(command.op), command.flags, command.arg, command.items);
    if (answer.error != golden::topology::TopologyError::None)
      throw std::invalid_argument("a program for the unit alone has a command in error");
    outcome.results.insert(outcome.results.end(), answer.results.begin(), answer.results.end());
  }
  outcome.counters = unit.lists().counters();
  outcome.sticky = unit.lists().sticky();
  return outcome;
}

std::vector<std::uint64_t> counter_list(const TopologyCounters& c) {
  return {c.quads_put,     c.quads_off_plane, c.quads_too_large, c.quads_saturated, c.nodes_linked,
          c.nodes_dropped, c.resolved,        c.facing_away,     c.off_plane,       c.uncertain,
          c.hit,           c.fallback,        c.shadow,          c.nodes_visited,   c.quads_tested};
}

std::string difference(const Outcome& got, const Outcome& want) {
  using golden::topology::describe_topology_result;
  for (std::size_t i = 0; i < got.results.size() && i < want.results.size(); ++i) {
    if (got.results[i] != want.results[i])
      return "result " + std::to_string(i) + ": " + describe_topology_result(got.results[i]) +
             " instead of " + describe_topology_result(want.results[i]);
  }
  if (got.results.size() != want.results.size())
    return std::to_string(got.results.size()) + " results instead of " + std::to_string(want.results.size());
  const auto got_counts = counter_list(got.counters), want_counts = counter_list(want.counters);
  for (std::size_t i = 0; i < got_counts.size(); ++i) {
    if (got_counts[i] != want_counts[i])
      return "counter " + std::to_string(i) + ": " + std::to_string(got_counts[i]) + " instead of " +
             std::to_string(want_counts[i]);
  }
  return got.sticky == want.sticky ? "" : "sticky flags differ";
}

}  // namespace gnomon::rtl_test::topology
