// SPDX-License-Identifier: Apache-2.0
// Runs a topology stream on the golden unit, for the tests and figures of this folder.
#pragma once

#include <gnomon/golden/narrow.hpp>
#include <gnomon/golden/stream.hpp>
#include <gnomon/golden/topology/unit.hpp>
#include <stdexcept>

#include "host/plan/topology_plan.hpp"

namespace gnomon::test {

struct TopologyRun {
  std::vector<golden::topology::TopologyResult> results;
  golden::topology::TopologyCounters counters;
  golden::topology::TopologySticky sticky;
};

/// What the hardware makes of a register's word.
inline std::int64_t register_value(std::size_t index, golden::Word word,
                                   const golden::HardwareConfig& config) {
  const auto format = golden::register_format(static_cast<golden::Register>(index), config);
  return format.is_signed ? golden::sign_extend(word, format.width)
                          : static_cast<std::int64_t>(golden::low_bits(word, format.width));
}

/// Executes the commands of the mode, takes the registers, skips the fence. Throws where the unit refuses a
/// command.
inline TopologyRun run_topology(const plan::TopologyPlan& plan, std::span<const golden::Word> stream) {
  namespace topology = golden::topology;
  topology::TopologyUnit unit(plan.config);
  TopologyRun run;
  golden::CommandReader reader(stream);
  while (const auto command = reader.next()) {
    if (command->header.op == static_cast<std::uint8_t>(golden::Op::SetRegisters)) {
      const auto value = [&](std::size_t i) { return register_value(i, command->items[i], plan.vpu.config); };
      topology::ProjectionRegisters registers;
      for (std::size_t i = 0; i < registers.matrix.size(); ++i) registers.matrix[i] = value(i);
      registers.offset_factor = value(static_cast<std::size_t>(golden::Register::OffsetFactor));
      unit.set_registers(registers);
    }
    if (!topology::is_topology_op(command->header.op)) continue;
    const auto outcome =
        unit.execute(command->header.op, command->header.flags, command->header.arg, command->items);
    if (outcome.error != topology::TopologyError::None) throw std::logic_error("the unit refused a command");
    for (const golden::Word word : outcome.results)
      run.results.push_back(topology::decode_topology_result(word));
  }
  run.counters = unit.lists().counters();
  run.sticky = unit.lists().sticky();
  return run;
}

}  // namespace gnomon::test
