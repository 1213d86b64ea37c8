// SPDX-License-Identifier: Apache-2.0
// The 16-bit instructions of RV32C: other spellings of 32-bit operations.
#include <array>

#include "sim/cpu/instruction.hpp"

namespace gnomon::sim::cpu {
namespace {

constexpr std::uint8_t kLink = 1, kStack = 2;

/// A five-bit register field, and the three-bit one that means x8..x15.
std::uint8_t reg(std::uint32_t w, unsigned low) {
  return static_cast<std::uint8_t>(bits(w, low + 4, low));
}
std::uint8_t reg8(std::uint32_t w, unsigned low) {
  return static_cast<std::uint8_t>(8U + bits(w, low + 2, low));
}

std::int32_t immediate6(std::uint32_t w) {
  return sign_extend(bits(w, 12, 12) << 5U | bits(w, 6, 2), 6);
}
std::int32_t shift_amount(std::uint32_t w) {
  return static_cast<std::int32_t>(bits(w, 6, 2));
}
std::int32_t jump_offset(std::uint32_t w) {  // [11|4|9:8|10|6|7|3:1|5]
  return sign_extend(bits(w, 12, 12) << 11U | bits(w, 11, 11) << 4U | bits(w, 10, 9) << 8U |
                         bits(w, 8, 8) << 10U | bits(w, 7, 7) << 6U | bits(w, 6, 6) << 7U |
                         bits(w, 5, 3) << 1U | bits(w, 2, 2) << 5U,
                     12);
}
std::int32_t word_offset(std::uint32_t w) {  // [5:3] at 12:10, [2|6] at 6:5
  return static_cast<std::int32_t>(bits(w, 12, 10) << 3U | bits(w, 6, 6) << 2U | bits(w, 5, 5) << 6U);
}

Operands addi4spn(std::uint32_t w) {  // [5:4|9:6|2|3]
  const std::uint32_t imm =
      bits(w, 12, 11) << 4U | bits(w, 10, 7) << 6U | bits(w, 6, 6) << 2U | bits(w, 5, 5) << 3U;
  return {reg8(w, 2), kStack, 0, static_cast<std::int32_t>(imm)};
}
Operands load(std::uint32_t w) {
  return {reg8(w, 2), reg8(w, 7), 0, word_offset(w)};
}
Operands store(std::uint32_t w) {
  return {0, reg8(w, 7), reg8(w, 2), word_offset(w)};
}
Operands load_stack(std::uint32_t w) {  // [5] at 12, [4:2|7:6] at 6:2
  const std::uint32_t imm = bits(w, 12, 12) << 5U | bits(w, 6, 4) << 2U | bits(w, 3, 2) << 6U;
  return {reg(w, 7), kStack, 0, static_cast<std::int32_t>(imm)};
}
Operands store_stack(std::uint32_t w) {  // [5:2|7:6] at 12:7
  const std::uint32_t imm = bits(w, 12, 9) << 2U | bits(w, 8, 7) << 6U;
  return {0, kStack, reg(w, 2), static_cast<std::int32_t>(imm)};
}
Operands add_immediate(std::uint32_t w) {
  return {reg(w, 7), reg(w, 7), 0, immediate6(w)};
}
Operands load_immediate(std::uint32_t w) {
  return {reg(w, 7), 0, 0, immediate6(w)};
}
Operands addi16sp(std::uint32_t w) {  // [9] at 12, [4|6|8:7|5] at 6:2
  const std::uint32_t imm = bits(w, 12, 12) << 9U | bits(w, 6, 6) << 4U | bits(w, 5, 5) << 6U |
                            bits(w, 4, 3) << 7U | bits(w, 2, 2) << 5U;
  return {kStack, kStack, 0, sign_extend(imm, 10)};
}
Operands load_upper(std::uint32_t w) {
  return {reg(w, 7), 0, 0, immediate6(w) * 4096};
}
Operands shift(std::uint32_t w) {
  return {reg(w, 7), reg(w, 7), 0, shift_amount(w)};
}
Operands shift8(std::uint32_t w) {
  return {reg8(w, 7), reg8(w, 7), 0, shift_amount(w)};
}
Operands and_immediate(std::uint32_t w) {
  return {reg8(w, 7), reg8(w, 7), 0, immediate6(w)};
}
Operands two_registers8(std::uint32_t w) {
  return {reg8(w, 7), reg8(w, 7), reg8(w, 2), 0};
}
Operands branch(std::uint32_t w) {  // [8|4:3] at 12:10, [7:6|2:1|5] at 6:2
  const std::uint32_t imm = bits(w, 12, 12) << 8U | bits(w, 11, 10) << 3U | bits(w, 6, 5) << 6U |
                            bits(w, 4, 3) << 1U | bits(w, 2, 2) << 5U;
  return {0, reg8(w, 7), 0, sign_extend(imm, 9)};
}
Operands jump(std::uint32_t w) {
  return {0, 0, 0, jump_offset(w)};
}
Operands jump_link(std::uint32_t w) {
  return {kLink, 0, 0, jump_offset(w)};
}
Operands jump_register(std::uint32_t w) {
  return {0, reg(w, 7), 0, 0};
}
Operands jump_register_link(std::uint32_t w) {
  return {kLink, reg(w, 7), 0, 0};
}
Operands move(std::uint32_t w) {
  return {reg(w, 7), 0, reg(w, 2), 0};
}
Operands two_registers(std::uint32_t w) {
  return {reg(w, 7), reg(w, 7), reg(w, 2), 0};
}
Operands none(std::uint32_t) {
  return {};
}

// Reserved encodings stand above the form that they are cut out of.
// clang-format off
constexpr std::array kHalves{
  row("reserved",   "000 00000000 --- 00",    Op::Illegal, none),  // addi4spn of 0; 0x0000 among them
  row("c.addi4spn", "000 -------- --- 00",    Op::Addi, addi4spn),
  row("c.lw",       "010 --- --- -- --- 00",  Op::Lw,   load),
  row("c.sw",       "110 --- --- -- --- 00",  Op::Sw,   store),
  row("c.addi",     "000 - ----- ----- 01",   Op::Addi, add_immediate),
  row("c.jal",      "001 ----------- 01",     Op::Jal,  jump_link),
  row("c.li",       "010 - ----- ----- 01",   Op::Addi, load_immediate),
  row("reserved",   "011 0 ----- 00000 01",   Op::Illegal, none),  // lui, addi16sp of 0
  row("c.addi16sp", "011 - 00010 ----- 01",   Op::Addi, addi16sp),
  row("c.lui",      "011 - ----- ----- 01",   Op::Lui,  load_upper),
  row("c.srli",     "100 0 00 --- ----- 01",  Op::Srli, shift8),
  row("c.srai",     "100 0 01 --- ----- 01",  Op::Srai, shift8),
  row("c.andi",     "100 - 10 --- ----- 01",  Op::Andi, and_immediate),
  row("c.sub",      "100 0 11 --- 00 --- 01", Op::Sub,  two_registers8),
  row("c.xor",      "100 0 11 --- 01 --- 01", Op::Xor,  two_registers8),
  row("c.or",       "100 0 11 --- 10 --- 01", Op::Or,   two_registers8),
  row("c.and",      "100 0 11 --- 11 --- 01", Op::And,  two_registers8),
  row("c.j",        "101 ----------- 01",     Op::Jal,  jump),
  row("c.beqz",     "110 --- --- ----- 01",   Op::Beq,  branch),
  row("c.bnez",     "111 --- --- ----- 01",   Op::Bne,  branch),
  row("c.slli",     "000 0 ----- ----- 10",   Op::Slli, shift),
  row("reserved",   "010 - 00000 ----- 10",   Op::Illegal, none),  // lwsp to x0
  row("c.lwsp",     "010 - ----- ----- 10",   Op::Lw,   load_stack),
  row("reserved",   "100 0 00000 00000 10",   Op::Illegal, none),  // jr to x0
  row("c.jr",       "100 0 ----- 00000 10",   Op::Jalr, jump_register),
  row("c.mv",       "100 0 ----- ----- 10",   Op::Add,  move),
  row("c.ebreak",   "100 1 00000 00000 10",   Op::Ebreak, none),
  row("c.jalr",     "100 1 ----- 00000 10",   Op::Jalr, jump_register_link),
  row("c.add",      "100 1 ----- ----- 10",   Op::Add,  two_registers),
  row("c.swsp",     "110 ------ ----- 10",    Op::Sw,   store_stack),
};
// clang-format on

}  // namespace

std::span<const InstructionRow> compressed_rows() {
  return kHalves;
}

}  // namespace gnomon::sim::cpu
