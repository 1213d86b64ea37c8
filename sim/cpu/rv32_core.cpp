// SPDX-License-Identifier: Apache-2.0
// Fetch, execute, trap.
#include "sim/cpu/rv32_core.hpp"

#include <type_traits>

#include "sim/cpu/arithmetic.hpp"

namespace gnomon::sim::cpu {
namespace {

constexpr std::size_t kCacheSize = 4096;

}  // namespace

Rv32Core::Rv32Core(Bus& bus, std::uint32_t reset_address, InstructionTable table)
    : bus_(bus), table_(table), reset_address_(reset_address), pc_(reset_address), cache_(kCacheSize) {}

void Rv32Core::reset() {
  x_.fill(0);
  pc_ = reset_address_;
  csr_.reset();
  counters_ = {};
  asleep_ = false;
  stop_requested_ = false;
  forget_all();
}

void Rv32Core::set_state(const HartState& state) {
  x_ = state.x;
  x_[0] = 0;
  pc_ = state.pc & ~1U;
}

void Rv32Core::set_interrupt(Interrupt line, bool level) {
  csr_.set_line(line, level);
  if (csr_.wakes()) asleep_ = false;
}

void Rv32Core::pass_time(std::uint64_t cycles) {
  counters_.cycles += cycles;
  if (asleep_) counters_.cycles_asleep += cycles;
}

Stop Rv32Core::run(std::uint64_t instructions) {
  for (;; --instructions) {
    if (stop_requested_) {
      stop_requested_ = false;
      return Stop::Requested;
    }
    if (asleep_) return Stop::Asleep;
    if (instructions == 0) return Stop::Budget;
    step();
  }
}

void Rv32Core::step() {
  if (csr_.interrupts()) take_interrupt();
  if (const Instruction* instruction = fetch()) execute(*instruction);
}

Rv32Core::CachedInstruction& Rv32Core::cached(std::uint32_t address) {
  return cache_[address / 2 % kCacheSize];
}

const Instruction* Rv32Core::fetch() {
  CachedInstruction& place = cached(pc_);
  if (place.address == pc_) return &place.instruction;
  const std::optional<std::uint32_t> first = fetch_half(pc_);
  if (!first) return nullptr;
  std::uint32_t word = *first;
  if (is_long(word)) {
    const std::optional<std::uint32_t> second = fetch_half(pc_ + 2);
    if (!second) return nullptr;
    word |= *second << 16U;
  }
  place = {pc_, decode(table_, word)};
  return &place.instruction;
}

std::optional<std::uint32_t> Rv32Core::fetch_half(std::uint32_t address) {
  const Reply reply = bus_.read(address, 2, Access::Fetch);
  wait(reply);
  if (!reply.fault) return reply.data & 0xFFFFU;
  raise(Cause::FetchFault, address);
  return std::nullopt;
}

void Rv32Core::forget(std::uint32_t address, unsigned bytes) {
  // An instruction of four bytes may begin two before.
  for (std::uint32_t at = (address & ~1U) - 2; at != (address & ~1U) + (bytes + 1) / 2 * 2; at += 2)
    if (cached(at).address == at) cached(at).address = kNoAddress;
}

void Rv32Core::forget_all() {
  for (CachedInstruction& place : cache_) place.address = kNoAddress;
}

void Rv32Core::retire(std::uint32_t next_pc, std::uint32_t cycles) {
  pc_ = next_pc;
  counters_.cycles += cycles;
  ++counters_.instructions;
}

void Rv32Core::finish(const Instruction& instruction, std::uint32_t value, std::uint32_t cycles) {
  set_x(instruction.operands.rd, value);
  retire(pc_ + instruction.length, cycles);
}

void Rv32Core::branch(const Instruction& instruction, bool taken) {
  const std::uint32_t step =
      taken ? static_cast<std::uint32_t>(instruction.operands.imm) : instruction.length;
  retire(pc_ + step, taken ? costs_.branch_taken : costs_.simple);
}

void Rv32Core::jump(const Instruction& instruction, std::uint32_t target) {
  set_x(instruction.operands.rd, pc_ + instruction.length);
  retire(target & ~1U, costs_.jump);
}

template <class T>
void Rv32Core::load(const Instruction& instruction) {
  const Operands& o = instruction.operands;
  const std::uint32_t address = x_[o.rs1] + static_cast<std::uint32_t>(o.imm);
  if (address % sizeof(T) != 0) return raise(Cause::LoadMisaligned, address);
  const Reply reply = bus_.read(address, sizeof(T), Access::Load);
  wait(reply);
  if (reply.fault) return raise(Cause::LoadFault, address);
  ++counters_.loads;
  finish(instruction, static_cast<std::uint32_t>(static_cast<T>(reply.data)), costs_.load_store);
}

void Rv32Core::store(const Instruction& instruction, unsigned bytes) {
  const Operands& o = instruction.operands;
  const std::uint32_t address = x_[o.rs1] + static_cast<std::uint32_t>(o.imm);
  if (address % bytes != 0) return raise(Cause::StoreMisaligned, address);
  const std::uint32_t data = bytes == 4 ? x_[o.rs2] : x_[o.rs2] & ((1U << 8 * bytes) - 1U);
  const Reply reply = bus_.write(address, bytes, data);
  wait(reply);
  if (reply.fault) return raise(Cause::StoreFault, address);
  ++counters_.stores;
  // Before the instruction is forgotten: it may overwrite itself.
  retire(pc_ + instruction.length, costs_.load_store);
  forget(address, bytes);
}

void Rv32Core::access_csr(const Instruction& instruction) {
  const Operands& o = instruction.operands;
  const bool immediate = instruction.op >= Op::Csrrwi;
  const bool replaces = instruction.op == Op::Csrrw || instruction.op == Op::Csrrwi;
  const bool sets = instruction.op == Op::Csrrs || instruction.op == Op::Csrrsi;
  const auto number = static_cast<std::uint32_t>(o.imm);
  const std::uint32_t operand = immediate ? o.rs1 : x_[o.rs1];
  const std::optional<std::uint32_t> old = csr_.read(number, counters_);
  if (!old) return raise(Cause::Illegal, instruction.word);
  const std::uint32_t value = replaces ? operand : sets ? *old | operand : *old & ~operand;
  const bool writes = replaces || o.rs1 != 0;
  if (writes && !csr_.write(number, value, counters_)) return raise(Cause::Illegal, instruction.word);
  finish(instruction, *old, costs_.simple);
}

void Rv32Core::sleep(const Instruction& instruction) {
  retire(pc_ + instruction.length, costs_.simple);
  asleep_ = !csr_.wakes();
}

void Rv32Core::raise(Cause cause, std::uint32_t value) {
  pc_ = csr_.enter(cause, pc_, value);
  counters_.cycles += costs_.trap_entry;
  ++counters_.exceptions;
}

void Rv32Core::take_interrupt() {
  pc_ = csr_.enter(csr_.first_interrupt(), pc_);
  counters_.cycles += costs_.trap_entry;
  ++counters_.interrupts;
}

void Rv32Core::execute(const Instruction& i) {
  const std::uint32_t a = x_[i.operands.rs1], b = x_[i.operands.rs2];
  const auto imm = static_cast<std::uint32_t>(i.operands.imm);
  const auto give = [&](std::uint32_t value) { finish(i, value, costs_.simple); };
  const auto divide = [&](std::uint32_t value) { finish(i, value, costs_.divide); };
  const auto multiply_high = [&](std::uint32_t value) { finish(i, value, costs_.multiply_high); };
  switch (i.op) {
    case Op::Illegal:
      return raise(Cause::Illegal, i.word);
    case Op::Lui:
      return give(imm);
    case Op::Auipc:
      return give(pc_ + imm);
    case Op::Jal:
      return jump(i, pc_ + imm);
    case Op::Jalr:
      return jump(i, a + imm);
    case Op::Beq:
      return branch(i, a == b);
    case Op::Bne:
      return branch(i, a != b);
    case Op::Blt:
      return branch(i, as_signed(a) < as_signed(b));
    case Op::Bge:
      return branch(i, as_signed(a) >= as_signed(b));
    case Op::Bltu:
      return branch(i, a < b);
    case Op::Bgeu:
      return branch(i, a >= b);
    case Op::Lb:
      return load<std::int8_t>(i);
    case Op::Lh:
      return load<std::int16_t>(i);
    case Op::Lw:
      return load<std::uint32_t>(i);
    case Op::Lbu:
      return load<std::uint8_t>(i);
    case Op::Lhu:
      return load<std::uint16_t>(i);
    case Op::Sb:
      return store(i, 1);
    case Op::Sh:
      return store(i, 2);
    case Op::Sw:
      return store(i, 4);
    case Op::Addi:
      return give(a + imm);
    case Op::Slti:
      return give(as_signed(a) < as_signed(imm) ? 1 : 0);
    case Op::Sltiu:
      return give(a < imm ? 1 : 0);
    case Op::Xori:
      return give(a ^ imm);
    case Op::Ori:
      return give(a | imm);
    case Op::Andi:
      return give(a & imm);
    case Op::Slli:
      return give(a << imm);
    case Op::Srli:
      return give(a >> imm);
    case Op::Srai:
      return give(shift_right_arithmetic(a, imm));
    case Op::Add:
      return give(a + b);
    case Op::Sub:
      return give(a - b);
    case Op::Sll:
      return give(a << (b & 31U));
    case Op::Slt:
      return give(as_signed(a) < as_signed(b) ? 1 : 0);
    case Op::Sltu:
      return give(a < b ? 1 : 0);
    case Op::Xor:
      return give(a ^ b);
    case Op::Srl:
      return give(a >> (b & 31U));
    case Op::Sra:
      return give(shift_right_arithmetic(a, b));
    case Op::Or:
      return give(a | b);
    case Op::And:
      return give(a & b);
    case Op::Fence:
      return retire(pc_ + i.length, costs_.simple);
    case Op::FenceI: {
      retire(pc_ + i.length, costs_.simple);
      return forget_all();
    }
    case Op::Ecall:
      return raise(Cause::EnvironmentCall, 0);
    case Op::Ebreak:
      return raise(Cause::Breakpoint, pc_);
    case Op::Mret:
      return retire(csr_.leave(), costs_.jump);
    case Op::Wfi:
      return sleep(i);
    case Op::Csrrw:
    case Op::Csrrs:
    case Op::Csrrc:
    case Op::Csrrwi:
    case Op::Csrrsi:
    case Op::Csrrci:
      return access_csr(i);
    case Op::Mul:
      return finish(i, a * b, costs_.multiply);
    case Op::Mulh:
      return multiply_high(mulh(a, b));
    case Op::Mulhsu:
      return multiply_high(mulhsu(a, b));
    case Op::Mulhu:
      return multiply_high(mulhu(a, b));
    case Op::Div:
      return divide(div(a, b));
    case Op::Divu:
      return divide(divu(a, b));
    case Op::Rem:
      return divide(rem(a, b));
    case Op::Remu:
      return divide(remu(a, b));
  }
}

}  // namespace gnomon::sim::cpu
