// SPDX-License-Identifier: Apache-2.0
// Programs of random instructions with loops, jumps and memory accesses.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "tests/sim/cpu/lockstep.hpp"

namespace gnomon::sim::cpu::test {

struct ProgramRun {
  std::uint64_t steps = 0;
  std::optional<std::string> difference;
};

/// Writes a program, runs it on both until it has made `limit` steps or comes to an instruction that it may
/// not execute (a memory access elsewhere, a trap), and counts what it has executed.
ProgramRun run_random_program(Lockstep& both, Random& random, int limit, std::map<Op, int>& executed);

}  // namespace gnomon::sim::cpu::test
