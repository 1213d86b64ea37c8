// SPDX-License-Identifier: Apache-2.0
// A soup of instructions around which control flow may wander. x2 and x8 point into the data, x9 into the
// code; nothing writes them.
#include "tests/sim/cpu/random_program.hpp"

#include <fmt/format.h>

#include <cstring>
#include <vector>

namespace gnomon::sim::cpu::test {
namespace {

constexpr std::uint32_t kStack = 2, kPointer = 8, kCodePointer = 9;
constexpr std::uint32_t kProgramSize = 4096, kProgramBase = kCodeBase + 0x8000;

bool reserved(unsigned index) {
  return index == kStack || index == kPointer || index == kCodePointer;
}
bool traps(Op op) {
  return op == Op::Illegal || (op >= Op::Ecall && op <= Op::Csrrci);
}

bool suits(const Instruction& instruction) {
  const Operands& o = instruction.operands;
  const Op op = instruction.op;
  if (traps(op) || reserved(o.rd)) return false;
  const auto offset = static_cast<std::uint32_t>(o.imm);
  if (is_load(op) || is_store(op))
    return (o.rs1 == kStack || o.rs1 == kPointer) && offset % access_size(op) == 0;
  if (op == Op::Jalr) return o.rs1 == kCodePointer && o.imm >= -1024 && o.imm < 1024;
  return true;
}

/// Jumps and branches of 32 bits stay near.
std::uint32_t near(const InstructionRow& row, std::uint32_t word) {
  const bool back = word >> 31U != 0;
  if (row.name == "jal")
    return back ? word | 0xFFU << 12U | 1U << 30U | 1U << 20U
                : word & ~(0xFFU << 12U | 1U << 30U | 1U << 20U);
  if (row.op >= Op::Beq && row.op <= Op::Bgeu && is_long(row.match))
    return back ? word | 7U << 28U | 1U << 7U : word & ~(7U << 28U | 1U << 7U);
  return word;
}

const InstructionRow& random_row(Random& random) {
  const InstructionTable table = rv32imc();
  return random.chance(50) ? random.pick(table.words) : random.pick(table.halves);
}

Instruction random_instruction(Random& random) {
  for (;;) {
    const InstructionRow& row = random_row(random);
    if (traps(row.op)) continue;
    for (int attempt = 0; attempt < 500; ++attempt) {
      const Instruction instruction = decode(rv32imc(), near(row, random_word(row, random)));
      if (suits(instruction)) return instruction;
    }
  }
}

std::vector<std::uint8_t> random_code(Random& random) {
  std::vector<std::uint8_t> code;
  while (code.size() < kProgramSize) {
    const Instruction instruction = random_instruction(random);
    const std::size_t at = code.size();
    code.resize(at + instruction.length);
    std::memcpy(&code[at], &instruction.word, instruction.length);
  }
  return code;
}

/// Jumps may lead into the middle of an instruction, where anything may stand.
bool may_execute(const Lockstep& both) {
  const HartState state = both.state();
  const Instruction instruction = decode(rv32imc(), both.code_word(state.pc));
  if (traps(instruction.op) || reserved(instruction.operands.rd)) return false;
  if (!is_load(instruction.op) && !is_store(instruction.op)) return true;
  const std::uint32_t address =
      state.x[instruction.operands.rs1] + static_cast<std::uint32_t>(instruction.operands.imm);
  const unsigned size = access_size(instruction.op);
  return address % size == 0 && address - kDataBase <= kDataSize - size;
}

}  // namespace

ProgramRun run_random_program(Lockstep& both, Random& random, int limit, std::map<Op, int>& executed) {
  both.put_code(kProgramBase, random_code(random));
  HartState state = random_state(random, kProgramBase + kProgramSize / 2);
  state.x[kStack] = state.x[kPointer] = kDataBase + kDataSize / 2;
  state.x[kCodePointer] = kProgramBase + kProgramSize / 2;
  both.set_state(state);
  ProgramRun run;
  for (int i = 0; i < limit && may_execute(both); ++i) {
    const std::uint32_t pc = both.state().pc;
    const std::uint32_t word = both.code_word(pc);
    ++executed[decode(rv32imc(), word).op];
    ++run.steps;
    if (auto difference = both.step()) {
      run.difference = fmt::format("{:08x} at {:08x}: {}", word, pc, *difference);
      break;
    }
  }
  return run;
}

}  // namespace gnomon::sim::cpu::test
