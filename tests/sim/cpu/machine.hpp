// SPDX-License-Identifier: Apache-2.0
// A core with memory and a program.
#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "sim/cpu/rv32_core.hpp"
#include "tests/sim/cpu/assemble.hpp"
#include "tests/sim/cpu/flat_memory.hpp"

namespace gnomon::sim::cpu::test {

inline constexpr std::uint32_t kHandler = kCodeBase + 0x1000;

struct Machine {
  FlatMemory memory;
  Rv32Core core{memory, kCodeBase};

  /// mtvec points to kHandler, which holds zeros: a handler that traps again.
  explicit Machine(std::initializer_list<std::uint32_t> program) {
    put(kCodeBase, program);
    HartState state = core.state();
    state.x[5] = kHandler;
    state.pc = kCodeBase + kCodeSize - 4;
    put(state.pc, {csrrw(0, number(Csr::Mtvec), 5)});
    core.set_state(state);
    core.run(1);
    core.set_state({{}, kCodeBase});
  }
  void put(std::uint32_t address, std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) {
      std::memcpy(&memory.code[address - kCodeBase], &word, sizeof word);
      address += 4;
    }
  }
  std::uint32_t csr(Csr csr) const { return core.csr(number(csr)).value_or(0); }
  std::uint32_t x(std::size_t index) const { return core.state().x[index]; }
  std::uint32_t pc() const { return core.state().pc; }
};

}  // namespace gnomon::sim::cpu::test
