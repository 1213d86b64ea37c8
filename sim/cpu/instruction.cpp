// SPDX-License-Identifier: Apache-2.0
// The 32-bit instructions: RV32I, M, Zicsr, Zifencei and the two of machine mode.
#include "sim/cpu/instruction.hpp"

#include <array>

namespace gnomon::sim::cpu {
namespace {

std::uint8_t reg(std::uint32_t word, unsigned low) {
  return static_cast<std::uint8_t>(bits(word, low + 4, low));
}

Operands format_r(std::uint32_t w) {
  return {reg(w, 7), reg(w, 15), reg(w, 20), 0};
}
Operands format_i(std::uint32_t w) {
  return {reg(w, 7), reg(w, 15), 0, sign_extend(bits(w, 31, 20), 12)};
}
Operands format_shift(std::uint32_t w) {
  return {reg(w, 7), reg(w, 15), 0, static_cast<std::int32_t>(bits(w, 24, 20))};
}
Operands format_s(std::uint32_t w) {
  return {0, reg(w, 15), reg(w, 20), sign_extend(bits(w, 31, 25) << 5U | bits(w, 11, 7), 12)};
}
Operands format_b(std::uint32_t w) {
  const std::uint32_t offset =
      bits(w, 31, 31) << 12U | bits(w, 7, 7) << 11U | bits(w, 30, 25) << 5U | bits(w, 11, 8) << 1U;
  return {0, reg(w, 15), reg(w, 20), sign_extend(offset, 13)};
}
Operands format_u(std::uint32_t w) {
  return {reg(w, 7), 0, 0, static_cast<std::int32_t>(w & 0xFFFFF000U)};
}
Operands format_j(std::uint32_t w) {
  const std::uint32_t offset =
      bits(w, 31, 31) << 20U | bits(w, 19, 12) << 12U | bits(w, 20, 20) << 11U | bits(w, 30, 21) << 1U;
  return {reg(w, 7), 0, 0, sign_extend(offset, 21)};
}
/// rs1 is a register or five bits of immediate, by operation; imm is the register's number.
Operands format_csr(std::uint32_t w) {
  return {reg(w, 7), reg(w, 15), 0, static_cast<std::int32_t>(bits(w, 31, 20))};
}
Operands format_none(std::uint32_t) {
  return {};
}

// clang-format off
constexpr std::array kWords{
  //             funct7  rs2   rs1   f3  rd    opcode
  row("lui",    "------- ----- ----- --- ----- 0110111", Op::Lui, format_u),
  row("auipc",  "------- ----- ----- --- ----- 0010111", Op::Auipc, format_u),
  row("jal",    "------- ----- ----- --- ----- 1101111", Op::Jal, format_j),
  row("jalr",   "------- ----- ----- 000 ----- 1100111", Op::Jalr, format_i),
  row("beq",    "------- ----- ----- 000 ----- 1100011", Op::Beq, format_b),
  row("bne",    "------- ----- ----- 001 ----- 1100011", Op::Bne, format_b),
  row("blt",    "------- ----- ----- 100 ----- 1100011", Op::Blt, format_b),
  row("bge",    "------- ----- ----- 101 ----- 1100011", Op::Bge, format_b),
  row("bltu",   "------- ----- ----- 110 ----- 1100011", Op::Bltu, format_b),
  row("bgeu",   "------- ----- ----- 111 ----- 1100011", Op::Bgeu, format_b),
  row("lb",     "------- ----- ----- 000 ----- 0000011", Op::Lb, format_i),
  row("lh",     "------- ----- ----- 001 ----- 0000011", Op::Lh, format_i),
  row("lw",     "------- ----- ----- 010 ----- 0000011", Op::Lw, format_i),
  row("lbu",    "------- ----- ----- 100 ----- 0000011", Op::Lbu, format_i),
  row("lhu",    "------- ----- ----- 101 ----- 0000011", Op::Lhu, format_i),
  row("sb",     "------- ----- ----- 000 ----- 0100011", Op::Sb, format_s),
  row("sh",     "------- ----- ----- 001 ----- 0100011", Op::Sh, format_s),
  row("sw",     "------- ----- ----- 010 ----- 0100011", Op::Sw, format_s),
  row("addi",   "------- ----- ----- 000 ----- 0010011", Op::Addi, format_i),
  row("slti",   "------- ----- ----- 010 ----- 0010011", Op::Slti, format_i),
  row("sltiu",  "------- ----- ----- 011 ----- 0010011", Op::Sltiu, format_i),
  row("xori",   "------- ----- ----- 100 ----- 0010011", Op::Xori, format_i),
  row("ori",    "------- ----- ----- 110 ----- 0010011", Op::Ori, format_i),
  row("andi",   "------- ----- ----- 111 ----- 0010011", Op::Andi, format_i),
  row("slli",   "0000000 ----- ----- 001 ----- 0010011", Op::Slli, format_shift),
  row("srli",   "0000000 ----- ----- 101 ----- 0010011", Op::Srli, format_shift),
  row("srai",   "0100000 ----- ----- 101 ----- 0010011", Op::Srai, format_shift),
  row("add",    "0000000 ----- ----- 000 ----- 0110011", Op::Add, format_r),
  row("sub",    "0100000 ----- ----- 000 ----- 0110011", Op::Sub, format_r),
  row("sll",    "0000000 ----- ----- 001 ----- 0110011", Op::Sll, format_r),
  row("slt",    "0000000 ----- ----- 010 ----- 0110011", Op::Slt, format_r),
  row("sltu",   "0000000 ----- ----- 011 ----- 0110011", Op::Sltu, format_r),
  row("xor",    "0000000 ----- ----- 100 ----- 0110011", Op::Xor, format_r),
  row("srl",    "0000000 ----- ----- 101 ----- 0110011", Op::Srl, format_r),
  row("sra",    "0100000 ----- ----- 101 ----- 0110011", Op::Sra, format_r),
  row("or",     "0000000 ----- ----- 110 ----- 0110011", Op::Or, format_r),
  row("and",    "0000000 ----- ----- 111 ----- 0110011", Op::And, format_r),
  row("mul",    "0000001 ----- ----- 000 ----- 0110011", Op::Mul, format_r),
  row("mulh",   "0000001 ----- ----- 001 ----- 0110011", Op::Mulh, format_r),
  row("mulhsu", "0000001 ----- ----- 010 ----- 0110011", Op::Mulhsu, format_r),
  row("mulhu",  "0000001 ----- ----- 011 ----- 0110011", Op::Mulhu, format_r),
  row("div",    "0000001 ----- ----- 100 ----- 0110011", Op::Div, format_r),
  row("divu",   "0000001 ----- ----- 101 ----- 0110011", Op::Divu, format_r),
  row("rem",    "0000001 ----- ----- 110 ----- 0110011", Op::Rem, format_r),
  row("remu",   "0000001 ----- ----- 111 ----- 0110011", Op::Remu, format_r),
  row("fence",  "------- ----- ----- 000 ----- 0001111", Op::Fence, format_none),
  row("fence.i","------- ----- ----- 001 ----- 0001111", Op::FenceI, format_none),
  row("ecall",  "0000000 00000 00000 000 00000 1110011", Op::Ecall, format_none),
  row("ebreak", "0000000 00001 00000 000 00000 1110011", Op::Ebreak, format_none),
  row("mret",   "0011000 00010 00000 000 00000 1110011", Op::Mret, format_none),
  row("wfi",    "0001000 00101 00000 000 00000 1110011", Op::Wfi, format_none),
  row("csrrw",  "------- ----- ----- 001 ----- 1110011", Op::Csrrw, format_csr),
  row("csrrs",  "------- ----- ----- 010 ----- 1110011", Op::Csrrs, format_csr),
  row("csrrc",  "------- ----- ----- 011 ----- 1110011", Op::Csrrc, format_csr),
  row("csrrwi", "------- ----- ----- 101 ----- 1110011", Op::Csrrwi, format_csr),
  row("csrrsi", "------- ----- ----- 110 ----- 1110011", Op::Csrrsi, format_csr),
  row("csrrci", "------- ----- ----- 111 ----- 1110011", Op::Csrrci, format_csr),
};
// clang-format on

}  // namespace

InstructionTable rv32imc() {
  return {kWords, compressed_rows()};
}

Instruction decode(const InstructionTable& table, std::uint32_t word) {
  const bool word_long = is_long(word);
  if (!word_long) word &= 0xFFFFU;
  Instruction result{Op::Illegal, static_cast<std::uint8_t>(word_long ? 4 : 2), {}, word};
  for (const InstructionRow& candidate : word_long ? table.words : table.halves) {
    if ((word & candidate.mask) != candidate.match) continue;
    result.op = candidate.op;
    result.operands = candidate.operands(word);
    break;
  }
  return result;
}

}  // namespace gnomon::sim::cpu
