// SPDX-License-Identifier: Apache-2.0
// Exceptions, interrupts and sleep: programs with known answers.
#include <gtest/gtest.h>

#include "tests/sim/cpu/machine.hpp"

namespace gnomon::sim::cpu::test {
namespace {

struct Trap {
  std::uint32_t cause, value, from;
  bool operator==(const Trap&) const = default;
  friend std::ostream& operator<<(std::ostream& out, const Trap& t) {
    return out << "cause " << t.cause << std::hex << " value " << t.value << " from " << t.from;
  }
};

/// Runs until the handler is reached; what it would read.
Trap trap_of(Machine& machine) {
  for (int i = 0; i < 10 && machine.pc() != kHandler; ++i) machine.core.run(1);
  EXPECT_EQ(machine.pc(), kHandler);
  return {machine.csr(Csr::Mcause), machine.csr(Csr::Mtval), machine.csr(Csr::Mepc)};
}
Trap trap_of(std::initializer_list<std::uint32_t> program) {
  Machine machine(program);
  return trap_of(machine);
}

TEST(Traps, SayWhatHappenedAndWhere) {
  constexpr std::uint32_t at = kCodeBase;
  EXPECT_EQ(trap_of({kEcall}), (Trap{11, 0, at}));
  EXPECT_EQ(trap_of({kNop, kEbreak}), (Trap{3, at + 4, at + 4}));
  EXPECT_EQ(trap_of({0x90029002}), (Trap{3, at, at})) << "c.ebreak";
  EXPECT_EQ(trap_of({0xFFFFFFFF}), (Trap{2, 0xFFFFFFFF, at}));
  EXPECT_EQ(trap_of({0x12340000}), (Trap{2, 0, at})) << "16 bits of zeros";
  EXPECT_EQ(trap_of({kSret}), (Trap{2, kSret, at}));
  EXPECT_EQ(trap_of({lui(1, 0x80000), lw(2, 1, 2)}), (Trap{4, kDataBase + 2, at + 4}));
  EXPECT_EQ(trap_of({lui(1, 0x80000), lh(2, 1, 1)}), (Trap{4, kDataBase + 1, at + 4}));
  EXPECT_EQ(trap_of({lw(2, 0, 16)}), (Trap{5, 16, at}));
  EXPECT_EQ(trap_of({lui(1, 0x80000), sw(2, 1, 1)}), (Trap{6, kDataBase + 1, at + 4}));
  EXPECT_EQ(trap_of({lui(1, 0x80000), sh(2, 1, 3)}), (Trap{6, kDataBase + 3, at + 4}));
  EXPECT_EQ(trap_of({sw(2, 0, -4)}), (Trap{7, 0xFFFFFFFC, at}));
  EXPECT_EQ(trap_of({jal(0, -16)}), (Trap{1, at - 16, at - 16}));
}

TEST(Traps, FetchFaultOfTheSecondHalf) {
  Machine machine({});
  constexpr std::uint32_t end = kCodeBase + kCodeSize;
  machine.put(end - 4, {kNop << 16U});
  machine.core.set_state({{}, end - 2});
  EXPECT_EQ(trap_of(machine), (Trap{1, end, end - 2}));
}

TEST(Traps, ChangeNothingElse) {
  Machine machine({lui(1, 0x80000), lw(1, 1, 2)});
  machine.core.run(2);
  EXPECT_EQ(machine.x(1), kDataBase);
  EXPECT_EQ(machine.core.counters().loads, 0u);
  EXPECT_EQ(machine.core.counters().exceptions, 1u);
}

TEST(Traps, SwitchInterruptsOffAndMretBack) {
  Machine machine({csrrsi(0, number(Csr::Mstatus), 8), kEcall, li(3, 7)});
  // The handler steps over the ecall.
  machine.put(kHandler,
              {csrrs(6, number(Csr::Mepc), 0), addi(6, 6, 4), csrrw(0, number(Csr::Mepc), 6), kMret});
  machine.core.run(2);
  EXPECT_EQ(machine.csr(Csr::Mstatus), 0x1880u) << "MPP, MPIE";
  machine.core.run(4);
  EXPECT_EQ(machine.csr(Csr::Mstatus), 0x1888u) << "MPP, MPIE, MIE";
  machine.core.run(1);
  EXPECT_EQ(machine.x(3), 7u);
}

/// mie = all three, mstatus.MIE = 1, in four instructions.
std::initializer_list<std::uint32_t> enabled() {
  static constexpr std::initializer_list<std::uint32_t> kProgram{
      lui(1, 1), addi(1, 1, -0x778), csrrw(0, number(Csr::Mie), 1), csrrsi(0, number(Csr::Mstatus), 8),
      jal(0, 0)};
  return kProgram;
}

TEST(Interrupts, ComeInOrderOfPriority) {
  Machine machine(enabled());
  machine.core.set_interrupt(Interrupt::Timer, true);
  machine.core.set_interrupt(Interrupt::External, true);
  machine.core.set_interrupt(Interrupt::Software, true);
  machine.core.run(4);
  EXPECT_EQ(machine.csr(Csr::Mip), 0x888u);
  EXPECT_EQ(machine.csr(Csr::Mie), 0x888u);
  machine.put(kHandler, {kNop, kMret});
  for (const Interrupt expected : {Interrupt::External, Interrupt::Software, Interrupt::Timer}) {
    machine.core.run(1);
    EXPECT_EQ(machine.csr(Csr::Mcause), 0x80000000u + static_cast<std::uint32_t>(expected));
    EXPECT_EQ(machine.csr(Csr::Mepc), kCodeBase + 16) << "before the instruction that it met";
    EXPECT_EQ(machine.csr(Csr::Mtval), 0u);
    machine.core.set_interrupt(expected, false);
    machine.core.run(1);
    EXPECT_EQ(machine.pc(), kCodeBase + 16);
  }
  EXPECT_EQ(machine.core.counters().interrupts, 3u);
  machine.core.run(5);
  EXPECT_EQ(machine.core.counters().interrupts, 3u);
}

TEST(Interrupts, WaitUntilBothEnablesAreSet) {
  Machine machine(enabled());
  machine.core.set_interrupt(Interrupt::External, true);
  machine.core.run(4);
  EXPECT_EQ(machine.core.counters().interrupts, 0u);
  machine.put(kHandler, {kNop, kNop, jal(0, 0)});
  machine.core.run(3);
  EXPECT_EQ(machine.core.counters().interrupts, 1u) << "none within the handler";
}

TEST(Interrupts, GoToTheirVector) {
  Machine machine({lui(1, kHandler >> 12U), addi(1, 1, 1), csrrw(0, number(Csr::Mtvec), 1), lui(1, 1),
                   addi(1, 1, -0x778), csrrw(0, number(Csr::Mie), 1), csrrsi(0, number(Csr::Mstatus), 8),
                   kEcall});
  machine.core.run(7);
  machine.core.set_interrupt(Interrupt::Timer, true);
  machine.put(kHandler + 4 * 7, {kNop, kMret});
  machine.core.run(1);
  EXPECT_EQ(machine.pc(), kHandler + 4 * 7 + 4);
  machine.core.set_interrupt(Interrupt::Timer, false);
  machine.core.run(2);
  EXPECT_EQ(machine.pc(), kHandler) << "exceptions go to the base";
}

/// Raises the external line when it is written.
struct Doorbell : FlatMemory {
  Iss* hart = nullptr;
  Reply write(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
    if (address != 0x1000) return FlatMemory::write(address, bytes, value);
    hart->set_interrupt(Interrupt::External, value != 0);
    if (value == 2) hart->request_stop();
    return {};
  }
};

TEST(Interrupts, FromADeviceMeetTheNextInstruction) {
  Doorbell memory;
  Rv32Core core(memory, kCodeBase);
  memory.hart = &core;
  Machine program({lui(5, kHandler >> 12U), csrrw(0, number(Csr::Mtvec), 5), lui(1, 1), addi(2, 1, -0x778),
                   csrrw(0, number(Csr::Mie), 2), csrrsi(0, number(Csr::Mstatus), 8), sw(1, 1, 0), li(3, 1)});
  program.put(kHandler, {kNop});
  memory.code = program.memory.code;
  core.run(8);
  EXPECT_EQ(core.csr(number(Csr::Mepc)), kCodeBase + 28);
  EXPECT_EQ(core.state().x[3], 0u);
}

TEST(Run, StopsWhenADeviceAsks) {
  Doorbell memory;
  Rv32Core core(memory, kCodeBase);
  memory.hart = &core;
  Machine program({lui(1, 1), li(2, 2), sw(2, 1, 0), li(3, 1), li(4, 1)});
  memory.code = program.memory.code;
  EXPECT_EQ(core.run(100), Stop::Requested);
  EXPECT_EQ(core.state().x[3], 0u) << "after the instruction under way";
  EXPECT_EQ(core.run(1), Stop::Budget);
  EXPECT_EQ(core.state().x[3], 1u);
}

TEST(Sleep, LastsUntilAnAdmittedLineRises) {
  Machine machine({lui(1, 1), addi(1, 1, -0x800), csrrw(0, number(Csr::Mie), 1), kWfi, li(3, 1), jal(0, 0)});
  EXPECT_EQ(machine.core.run(100), Stop::Asleep);
  const Counters before = machine.core.counters();
  EXPECT_EQ(before.instructions, 5u) << "one set mtvec; wfi itself retires";
  machine.core.pass_time(1000);
  machine.core.set_interrupt(Interrupt::Timer, true);
  EXPECT_EQ(machine.core.run(100), Stop::Asleep) << "not in mie";
  machine.core.set_interrupt(Interrupt::External, true);
  EXPECT_EQ(machine.core.run(1), Stop::Budget);
  EXPECT_EQ(machine.x(3), 1u) << "no trap while mstatus.MIE is 0";
  const Counters after = machine.core.counters();
  EXPECT_EQ(after.cycles - before.cycles, 1001u);
  EXPECT_EQ(after.cycles_asleep, 1000u);
  machine.core.pass_time(10);
  EXPECT_EQ(machine.core.counters().cycles_asleep, 1000u) << "held, not asleep";
}

TEST(Sleep, DoesNotBeginWithALineUp) {
  Machine machine({lui(1, 1), addi(1, 1, -0x800), csrrw(0, number(Csr::Mie), 1), kWfi, li(3, 1), jal(0, 0)});
  machine.core.set_interrupt(Interrupt::External, true);
  EXPECT_EQ(machine.core.run(100), Stop::Budget);
  EXPECT_EQ(machine.x(3), 1u);
}

}  // namespace
}  // namespace gnomon::sim::cpu::test
