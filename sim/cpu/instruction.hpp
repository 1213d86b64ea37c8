// SPDX-License-Identifier: Apache-2.0
// Instructions as the manual prints them: bit patterns, operations, operand formats (docs/cpu.md).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace gnomon::sim::cpu {

// Grouped as in the manual's listing.
// clang-format off
enum class Op : std::uint8_t {
  Illegal,
  Lui, Auipc, Jal, Jalr,
  Beq, Bne, Blt, Bge, Bltu, Bgeu,
  Lb, Lh, Lw, Lbu, Lhu, Sb, Sh, Sw,
  Addi, Slti, Sltiu, Xori, Ori, Andi, Slli, Srli, Srai,
  Add, Sub, Sll, Slt, Sltu, Xor, Srl, Sra, Or, And,
  Fence, FenceI, Ecall, Ebreak, Mret, Wfi,
  Csrrw, Csrrs, Csrrc, Csrrwi, Csrrsi, Csrrci,
  Mul, Mulh, Mulhsu, Mulhu, Div, Divu, Rem, Remu,
};
// clang-format on

struct Operands {
  std::uint8_t rd = 0, rs1 = 0, rs2 = 0;
  std::int32_t imm = 0;  ///< sign-extended; the shift amount of a shift, the number of a CSR
};

struct Instruction {
  Op op = Op::Illegal;
  std::uint8_t length = 0;  ///< bytes: 2 or 4
  Operands operands;
  std::uint32_t word = 0;  ///< as fetched; the upper half is 0 where length is 2
};

/// A row of the instruction table; the first that matches counts.
struct InstructionRow {
  std::string_view name;
  std::uint32_t mask;   ///< bits that the pattern fixes
  std::uint32_t match;  ///< their values
  Op op;
  Operands (*operands)(std::uint32_t word);
};

/// Rows of the 32-bit and of the 16-bit instructions.
struct InstructionTable {
  std::span<const InstructionRow> words;
  std::span<const InstructionRow> halves;
};

/// RV32IMC, Zicsr, Zifencei, mret and wfi.
InstructionTable rv32imc();

/// Whether a half-word is the first one of a 32-bit instruction.
constexpr bool is_long(std::uint32_t half) {
  return (half & 3U) == 3U;
}

/// `word` holds a 32-bit instruction, or a 16-bit one in its low half.
Instruction decode(const InstructionTable& table, std::uint32_t word);

/// A row from a pattern of '0', '1' and '-' (blanks mean nothing), 16 or 32 bits, highest first. A pattern of
/// another length, or with another character, does not compile.
consteval InstructionRow row(std::string_view name, std::string_view pattern, Op op,
                             Operands (*operands)(std::uint32_t)) {
  InstructionRow result{name, 0, 0, op, operands};
  int bits = 0;
  for (const char c : pattern) {
    if (c == ' ') continue;
    if (c != '0' && c != '1' && c != '-') throw "a pattern holds 0, 1, - and blanks";
    result.mask = result.mask << 1U | (c != '-' ? 1U : 0U);
    result.match = result.match << 1U | (c == '1' ? 1U : 0U);
    ++bits;
  }
  if (bits != 16 && bits != 32) throw "a pattern has 16 or 32 bits";
  return result;
}

/// Bits high..low of a word.
constexpr std::uint32_t bits(std::uint32_t word, unsigned high, unsigned low) {
  return (word >> low) & ((2U << (high - low)) - 1U);
}

/// The low `width` bits as a two's complement number.
constexpr std::int32_t sign_extend(std::uint32_t value, unsigned width) {
  const std::uint32_t sign = 1U << (width - 1);
  return static_cast<std::int32_t>((value ^ sign) - sign);
}

/// Rows of the 16-bit instructions (compressed.cpp).
std::span<const InstructionRow> compressed_rows();

}  // namespace gnomon::sim::cpu
