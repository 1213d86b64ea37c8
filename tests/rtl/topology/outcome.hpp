// SPDX-License-Identifier: Apache-2.0
// Programs for topology mode's unit, and what comes of them: by golden, and as the hardware reports it.
#pragma once

#include <cstdint>
#include <gnomon/golden/topology/unit.hpp>
#include <span>
#include <string>
#include <vector>

namespace gnomon::rtl_test::topology {

using golden::topology::ProjectionRegisters;
using golden::topology::TopologyConfig;
using golden::topology::TopologyCounters;
using golden::topology::TopologyOp;
using golden::topology::TopologySticky;
using golden::topology::Word;

/// A good command with its items; or registers to set before the next one.
struct Command {
  bool sets_registers = false;
  ProjectionRegisters registers{};
  TopologyOp op = TopologyOp::ClearLists;
  std::uint8_t flags = 0;
  std::uint32_t arg = 0;
  std::vector<Word> items{};
};
using Program = std::vector<Command>;

struct Outcome {
  std::vector<Word> results;
  TopologyCounters counters;
  TopologySticky sticky;
};

/// Golden's answer, from power-up. Throws std::invalid_argument if a command is in error: errors are the
/// decoder's.
Outcome expected(std::span<const Command> program, const TopologyConfig& config);

/// Counters in the order of the page.
std::vector<std::uint64_t> counter_list(const TopologyCounters& counters);

/// Empty if equal; else the first difference in words.
std::string difference(const Outcome& got, const Outcome& want);

}  // namespace gnomon::rtl_test::topology
