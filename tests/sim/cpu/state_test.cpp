// SPDX-License-Identifier: Apache-2.0
// Control and status registers, counters, time, the decode cache, reset.
#include <gtest/gtest.h>

#include <set>

#include "tests/sim/cpu/machine.hpp"

namespace gnomon::sim::cpu::test {
namespace {

bool traps(Machine& machine) {
  const std::uint64_t before = machine.core.counters().exceptions;
  machine.core.run(1);
  return machine.core.counters().exceptions != before;
}
bool traps(std::initializer_list<std::uint32_t> program) {
  Machine machine(program);
  return traps(machine);
}

/// What is left after writing all ones, and after writing all zeros then.
std::pair<std::uint32_t, std::uint32_t> written(Csr csr) {
  Machine machine({li(1, -1), csrrw(0, number(csr), 1), csrrs(2, number(csr), 0), csrrw(0, number(csr), 0),
                   csrrs(3, number(csr), 0)});
  machine.core.run(5);
  EXPECT_EQ(machine.core.counters().exceptions, 0u);
  return {machine.x(2), machine.x(3)};
}

TEST(Csr, KeepsTheBitsThatExist) {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  EXPECT_EQ(written(Csr::Mstatus), (Pair{0x1888, 0x1800}));
  EXPECT_EQ(written(Csr::Misa), (Pair{0x40001104, 0x40001104}));
  EXPECT_EQ(written(Csr::Mie), (Pair{0x888, 0}));
  EXPECT_EQ(written(Csr::Mip), (Pair{0, 0}));
  EXPECT_EQ(written(Csr::Mtvec), (Pair{0xFFFFFFFD, 0}));
  EXPECT_EQ(written(Csr::Mscratch), (Pair{0xFFFFFFFF, 0}));
  EXPECT_EQ(written(Csr::Mepc), (Pair{0xFFFFFFFE, 0}));
  EXPECT_EQ(written(Csr::Mcause), (Pair{0xFFFFFFFF, 0}));
  EXPECT_EQ(written(Csr::Mtval), (Pair{0xFFFFFFFF, 0}));
  EXPECT_EQ(written(Csr::Mcountinhibit), (Pair{0, 0}));
  EXPECT_EQ(written(Csr::Mstatush), (Pair{0, 0}));
  EXPECT_EQ(written(Csr::Mhpmcounter3), (Pair{0, 0}));
  EXPECT_EQ(written(Csr::Mhpmcounter31h), (Pair{0, 0}));
  EXPECT_EQ(written(Csr::Mhpmevent31), (Pair{0, 0}));
}

TEST(Csr, ThereAreThoseOfThePageAndNoOthers) {
  std::set<std::uint32_t> there;
  for (std::uint32_t n = 0; n < 4096; ++n)
    if (!traps({csrrs(1, n, 0)})) there.insert(n);
  // 8 trap registers, misa and mstatush; mcountinhibit; 4 × 2 counters; 29 × 3 that read 0; 5 that identify.
  EXPECT_EQ(there.size(), 8u + 2 + 1 + 8 + 87 + 5);
  EXPECT_FALSE(there.contains(0xC01)) << "time";
  EXPECT_FALSE(there.contains(0x100)) << "sstatus";
  for (const std::uint32_t n : there) EXPECT_EQ(traps({csrrw(1, n, 0)}), n >= 0xC00) << std::hex << n;
}

TEST(Csr, OperationsSetClearAndReplace) {
  constexpr std::uint32_t kScratch = number(Csr::Mscratch);
  Machine machine({li(1, 0x0F0), csrrw(2, kScratch, 1), li(1, 0x03C), csrrs(3, kScratch, 1), li(1, 0x011),
                   csrrc(4, kScratch, 1), csrrwi(5, kScratch, 21), csrrsi(6, kScratch, 10),
                   csrrci(7, kScratch, 4), csrrs(8, kScratch, 0)});
  machine.core.run(10);
  const std::array<std::uint32_t, 7> expected{0, 0x0F0, 0x0FC, 0x0EC, 21, 31, 27};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(machine.x(i + 2), expected[i]) << i;
  EXPECT_EQ(machine.core.counters().exceptions, 0u);
}

TEST(Csr, ReadOnlyOnesMayBeReadBySetAndClear) {
  EXPECT_FALSE(traps({csrrs(1, number(Csr::Mhartid), 0)}));
  EXPECT_FALSE(traps({csrrci(1, number(Csr::Cycle), 0)}));
  EXPECT_TRUE(traps({csrrsi(1, number(Csr::Cycle), 1)}));
  EXPECT_TRUE(traps({csrrs(1, number(Csr::Mhartid), 2)})) << "a register that holds 0 writes all the same";
}

TEST(Counters, CountWhatRetires) {
  constexpr std::uint32_t kInstret = number(Csr::Minstret);
  Machine machine({csrrs(1, kInstret, 0), kNop, csrrs(2, kInstret, 0), kEcall});
  machine.put(kHandler, {csrrs(3, kInstret, 0)});
  machine.core.run(5);
  EXPECT_EQ(machine.x(2) - machine.x(1), 2u);
  EXPECT_EQ(machine.x(3) - machine.x(2), 1u) << "the ecall does not";
}

TEST(Counters, ReadWhatWasWritten) {
  Machine machine({li(1, -1), csrrw(0, number(Csr::Minstret), 1), csrrs(2, number(Csr::Minstret), 0),
                   csrrs(3, number(Csr::Minstret), 0), csrrs(4, number(Csr::Minstreth), 0),
                   csrrw(0, number(Csr::Mcycle), 1), csrrs(5, number(Csr::Mcycle), 0),
                   csrrwi(0, number(Csr::Mcycleh), 9), csrrs(6, number(Csr::Mcycleh), 0)});
  machine.core.run(9);
  EXPECT_EQ(machine.x(2), 0xFFFFFFFFu);
  EXPECT_EQ(machine.x(3), 0u);
  EXPECT_EQ(machine.x(4), 1u) << "the carry";
  EXPECT_EQ(machine.x(5), 0xFFFFFFFFu);
  EXPECT_EQ(machine.x(6), 9u);
  EXPECT_EQ(machine.core.counters().instructions, 10u) << "our own count is nobody's to change";
}

/// Cycles of the last of some instructions.
std::uint64_t cost(std::initializer_list<std::uint32_t> program, std::uint32_t wait = 0) {
  Machine machine(program);
  machine.core.run(program.size() - 1);
  const Counters before = machine.core.counters();
  machine.memory.wait_cycles = wait;
  machine.core.run(1);
  EXPECT_EQ(machine.core.counters().cycles_waited - before.cycles_waited, wait);
  return machine.core.counters().cycles - before.cycles;
}

TEST(Counters, CyclesAreThoseOfThePage) {
  EXPECT_EQ(cost({kNop}), 1u);
  EXPECT_EQ(cost({bne(0, 0, 8)}), 1u);
  EXPECT_EQ(cost({li(1, 1), bne(0, 1, 8)}), 3u);
  EXPECT_EQ(cost({jal(0, 8)}), 2u);
  EXPECT_EQ(cost({mul(1, 2, 3)}), 1u);
  EXPECT_EQ(cost({mulh(1, 2, 3)}), 2u);
  EXPECT_EQ(cost({divu(1, 2, 3)}), 37u);
  EXPECT_EQ(cost({lui(1, 0x80000), lw(2, 1, 0)}), 2u);
  EXPECT_EQ(cost({lui(1, 0x80000), sw(2, 1, 0)}), 2u);
  EXPECT_EQ(cost({kEcall}), 4u);
}

TEST(Counters, TheBusMayLetItWait) {
  Machine machine({lui(1, 0x80000), jal(0, 8), 0, lw(2, 1, 0), jal(0, -4)});
  machine.core.run(4);  // from here on, everything is in the decode cache
  const Counters before = machine.core.counters();
  machine.memory.wait_cycles = 5;
  machine.core.run(2);
  EXPECT_EQ(machine.core.counters().cycles - before.cycles, 2u + 2u + 5u);
  EXPECT_EQ(machine.core.counters().cycles_waited - before.cycles_waited, 5u);
}

TEST(DecodeCache, FetchesOnceAndSeesItsOwnStores) {
  // Writes the instruction in x2 over the one at +16, and runs it.
  Machine machine({lui(1, kCodeBase >> 12U), lui(2, 0), sw(2, 1, 16), kNop, li(3, 1), jal(0, -8)});
  machine.memory.code_writable = true;
  HartState state{{}, kCodeBase + 12};
  machine.core.set_state(state);
  machine.core.run(3);
  const std::uint64_t fetches = machine.memory.fetches;
  machine.core.run(30);
  EXPECT_EQ(machine.memory.fetches, fetches);
  EXPECT_EQ(machine.x(3), 1u);
  state = {{}, kCodeBase + 8};
  state.x[1] = kCodeBase;
  state.x[2] = li(3, 2);
  machine.core.set_state(state);
  machine.core.run(3);
  EXPECT_EQ(machine.x(3), 2u);
}

TEST(DecodeCache, SeesAStoreIntoAnInstructionsSecondHalf) {
  Machine machine({li(3, 1), jal(0, -4), sh(2, 1, 2), jal(0, -12)});
  machine.memory.code_writable = true;
  machine.core.run(2);
  HartState state{{}, kCodeBase + 8};
  state.x[1] = kCodeBase;
  state.x[2] = li(3, 5) >> 16U;
  machine.core.set_state(state);
  machine.core.run(3);
  EXPECT_EQ(machine.x(3), 5u);
}

TEST(DecodeCache, FenceIShowsWhatOthersWrote) {
  Machine machine({li(3, 1), kFenceI, jal(0, -8)});
  machine.core.run(1);
  machine.put(kCodeBase, {li(3, 2)});
  machine.core.set_state({{}, kCodeBase});
  machine.core.run(1);
  EXPECT_EQ(machine.x(3), 1u) << "stale, as the manual allows";
  machine.core.run(3);
  EXPECT_EQ(machine.x(3), 2u);
}

TEST(Reset, LeavesNothingButTheLines) {
  Machine machine({lui(1, 1), csrrw(0, number(Csr::Mscratch), 1), csrrsi(0, number(Csr::Mstatus), 8), kWfi});
  machine.core.run(4);
  machine.core.set_interrupt(Interrupt::Software, true);
  machine.core.reset();
  EXPECT_EQ(machine.core.state(), (HartState{{}, kCodeBase}));
  EXPECT_EQ(machine.core.counters(), Counters{});
  EXPECT_EQ(machine.csr(Csr::Mscratch), 0u);
  EXPECT_EQ(machine.csr(Csr::Mstatus), 0x1800u);
  EXPECT_EQ(machine.csr(Csr::Mip), 8u);
  EXPECT_EQ(machine.core.run(1), Stop::Budget);
}

}  // namespace
}  // namespace gnomon::sim::cpu::test
