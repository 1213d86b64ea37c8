// SPDX-License-Identifier: Apache-2.0
// Stepping, comparing, and states worth starting from.
#include "tests/sim/cpu/lockstep.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <limits>

namespace gnomon::sim::cpu::test {
namespace {

constexpr std::array<std::uint8_t, 4> kJumpToItself{0x6F, 0, 0, 0};

Outcome outcome_of(std::uint32_t cause) {
  switch (static_cast<Cause>(cause)) {
    case Cause::Illegal:
      return Outcome::Illegal;
    case Cause::Breakpoint:
      return Outcome::Breakpoint;
    case Cause::EnvironmentCall:
      return Outcome::EnvironmentCall;
    case Cause::LoadFault:
    case Cause::StoreFault:
    case Cause::LoadMisaligned:
    case Cause::StoreMisaligned:
      return Outcome::MemoryFault;
    default:
      return Outcome::Other;
  }
}

}  // namespace

Lockstep::Lockstep(InstructionTable table) : core_(memory_, kCodeBase, table) {}

void Lockstep::put_code(std::uint32_t address, std::span<const std::uint8_t> bytes) {
  memory_.put_code(address, bytes);
  oracle_.put_code(address, bytes);
  const HartState kept = core_.state();
  core_.reset();  // forgets what it has decoded
  core_.set_state(kept);
}

void Lockstep::fill_data(Random& random) {
  for (std::uint8_t& byte : memory_.data) byte = static_cast<std::uint8_t>(random.bits());
  oracle_.put_data(memory_.data);
}

void Lockstep::set_state(const HartState& state) {
  core_.set_state(state);
  oracle_.set_state(state);
}

std::uint32_t Lockstep::code_word(std::uint32_t address) const {
  std::uint32_t word = 0;
  if (address - kCodeBase <= kCodeSize - sizeof word)
    std::memcpy(&word, &memory_.code[address - kCodeBase], sizeof word);
  return word;
}

/// A trap shows as such; pc goes back to where it happened, as the oracle leaves it.
Outcome Lockstep::step_core() {
  const Counters before = core_.counters();
  const HartState at = core_.state();
  core_.run(1);
  if (core_.counters().exceptions == before.exceptions) return Outcome::Done;
  HartState state = core_.state();
  state.pc = at.pc;
  core_.set_state(state);
  return outcome_of(core_.csr(static_cast<std::uint32_t>(Csr::Mcause)).value_or(0));
}

std::optional<std::string> Lockstep::step() {
  const Outcome ours = step_core();
  last = oracle_.step();
  ++compared;
  if (ours != last)
    return fmt::format("outcome {}, oracle {}", static_cast<int>(ours), static_cast<int>(last));
  const HartState our_state = core_.state(), oracle_state = oracle_.state();
  if (our_state != oracle_state) return describe(our_state, oracle_state);
  return std::nullopt;
}

std::optional<std::string> Lockstep::compare_data() {
  const std::vector<std::uint8_t> expected = oracle_.data(kDataBase, kDataSize);
  for (std::uint32_t i = 0; i < kDataSize; ++i)
    if (memory_.data[i] != expected[i])
      return fmt::format("byte {:08x} is {:02x}, oracle {:02x}", kDataBase + i, memory_.data[i], expected[i]);
  return std::nullopt;
}

std::uint32_t edge_value(Random& random) {
  static constexpr std::array<std::uint32_t, 14> kEdges{
      0,      1,      2,          31,         32,         0x7F,       0x80,
      0xFFFF, 0x8000, 0x7FFFFFFF, 0x80000000, 0x80000001, 0xFFFFFFFE, 0xFFFFFFFF};
  if (random.chance(60)) return random.pick(std::span<const std::uint32_t>(kEdges));
  return static_cast<std::uint32_t>(random.bits());
}

HartState random_state(Random& random, std::uint32_t pc) {
  HartState state;
  for (std::size_t i = 1; i < 32; ++i) state.x[i] = edge_value(random);
  state.pc = pc;
  return state;
}

std::uint32_t random_word(const InstructionRow& row, Random& random) {
  const bool is_half = !is_long(row.match);
  for (int attempt = 0;; ++attempt) {
    auto word = (static_cast<std::uint32_t>(random.bits()) & ~row.mask) | row.match;
    if (is_half) word &= 0xFFFFU;
    const Instruction instruction = decode(rv32imc(), word);
    if (instruction.op == row.op || attempt == 100) return word;
  }
}

bool is_load(Op op) {
  return op >= Op::Lb && op <= Op::Lhu;
}
bool is_store(Op op) {
  return op >= Op::Sb && op <= Op::Sw;
}
unsigned access_size(Op op) {
  if (op == Op::Lb || op == Op::Lbu || op == Op::Sb) return 1;
  return op == Op::Lh || op == Op::Lhu || op == Op::Sh ? 2 : 4;
}

bool aim_at_data(HartState& state, const Instruction& instruction, Random& random) {
  const unsigned base = instruction.operands.rs1;
  if (base == 0) return false;
  const unsigned size = access_size(instruction.op);
  const auto offset = static_cast<std::uint32_t>(random.between(0, kDataSize / size - 1)) * size;
  state.x[base] = kDataBase + offset - static_cast<std::uint32_t>(instruction.operands.imm);
  return true;
}

std::optional<std::string> try_word(Lockstep& both, std::uint32_t word, Random& random) {
  const std::uint32_t pc = kCodeBase + static_cast<std::uint32_t>(random.between(0, kCodeSize / 2 - 8)) * 2;
  const Instruction instruction = decode(rv32imc(), word);
  std::array<std::uint8_t, 8> code{};
  std::memcpy(code.data(), &word, instruction.length);
  // The oracle translates up to the next jump; let it be near.
  std::memcpy(code.data() + instruction.length, kJumpToItself.data(), kJumpToItself.size());
  both.put_code(pc, std::span(code).first(instruction.length + kJumpToItself.size()));
  HartState state = random_state(random, pc);
  if (random.chance(30) && instruction.operands.rs1 != 0)
    state.x[instruction.operands.rs2] = state.x[instruction.operands.rs1];
  if (is_load(instruction.op) || is_store(instruction.op)) aim_at_data(state, instruction, random);
  state.x[0] = 0;
  both.set_state(state);
  if (auto difference = both.step()) return fmt::format("{:08x} at {:08x}: {}", word, pc, *difference);
  return std::nullopt;
}

std::string describe(const HartState& ours, const HartState& oracle) {
  if (ours.pc != oracle.pc) return fmt::format("pc {:08x}, oracle {:08x}", ours.pc, oracle.pc);
  for (std::size_t i = 0; i < 32; ++i)
    if (ours.x[i] != oracle.x[i]) return fmt::format("x{} {:08x}, oracle {:08x}", i, ours.x[i], oracle.x[i]);
  return "equal";
}

}  // namespace gnomon::sim::cpu::test
