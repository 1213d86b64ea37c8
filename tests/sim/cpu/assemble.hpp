// SPDX-License-Identifier: Apache-2.0
// Instruction words for programs with known answers.
#pragma once

#include <cstdint>

#include "sim/cpu/csr_file.hpp"

namespace gnomon::sim::cpu::test {

constexpr std::uint32_t kEcall = 0x00000073, kEbreak = 0x00100073, kMret = 0x30200073, kWfi = 0x10500073,
                        kFence = 0x0FF0000F, kFenceI = 0x0000100F, kNop = 0x00000013, kSret = 0x10200073;

constexpr std::uint32_t format_i(std::uint32_t opcode, std::uint32_t function, unsigned rd, unsigned rs1,
                                 int imm) {
  return static_cast<std::uint32_t>(imm) << 20U | rs1 << 15U | function << 12U | rd << 7U | opcode;
}
constexpr std::uint32_t addi(unsigned rd, unsigned rs1, int imm) {
  return format_i(0x13, 0, rd, rs1, imm);
}
constexpr std::uint32_t li(unsigned rd, int imm) {
  return addi(rd, 0, imm);
}
constexpr std::uint32_t lui(unsigned rd, std::uint32_t upper) {
  return upper << 12U | rd << 7U | 0x37U;
}
constexpr std::uint32_t lh(unsigned rd, unsigned rs1, int imm) {
  return format_i(0x03, 1, rd, rs1, imm);
}
constexpr std::uint32_t lw(unsigned rd, unsigned rs1, int imm) {
  return format_i(0x03, 2, rd, rs1, imm);
}
constexpr std::uint32_t store(std::uint32_t function, unsigned rs2, unsigned rs1, int imm) {
  const auto offset = static_cast<std::uint32_t>(imm);
  return (offset >> 5U & 127U) << 25U | rs2 << 20U | rs1 << 15U | function << 12U | (offset & 31U) << 7U |
         0x23U;
}
constexpr std::uint32_t sh(unsigned rs2, unsigned rs1, int imm) {
  return store(1, rs2, rs1, imm);
}
constexpr std::uint32_t sw(unsigned rs2, unsigned rs1, int imm) {
  return store(2, rs2, rs1, imm);
}
constexpr std::uint32_t mul(unsigned rd, unsigned rs1, unsigned rs2) {
  return 1U << 25U | rs2 << 20U | rs1 << 15U | rd << 7U | 0x33U;
}
constexpr std::uint32_t mulh(unsigned rd, unsigned rs1, unsigned rs2) {
  return mul(rd, rs1, rs2) | 1U << 12U;
}
constexpr std::uint32_t divu(unsigned rd, unsigned rs1, unsigned rs2) {
  return mul(rd, rs1, rs2) | 5U << 12U;
}
/// Offsets in bytes, -1024..1023, even.
constexpr std::uint32_t jal(unsigned rd, int offset) {
  const auto o = static_cast<std::uint32_t>(offset);
  return (o >> 20U & 1U) << 31U | (o >> 1U & 0x3FFU) << 21U | (o >> 11U & 1U) << 20U |
         (o >> 12U & 0xFFU) << 12U | rd << 7U | 0x6FU;
}
constexpr std::uint32_t bne(unsigned rs1, unsigned rs2, int offset) {
  const auto o = static_cast<std::uint32_t>(offset);
  return (o >> 12U & 1U) << 31U | (o >> 5U & 63U) << 25U | rs2 << 20U | rs1 << 15U | 1U << 12U |
         (o >> 1U & 15U) << 8U | (o >> 11U & 1U) << 7U | 0x63U;
}
constexpr std::uint32_t csr_word(std::uint32_t function, unsigned rd, std::uint32_t number, unsigned rs1) {
  return number << 20U | rs1 << 15U | function << 12U | rd << 7U | 0x73U;
}
constexpr std::uint32_t csrrw(unsigned rd, std::uint32_t number, unsigned rs1) {
  return csr_word(1, rd, number, rs1);
}
constexpr std::uint32_t csrrs(unsigned rd, std::uint32_t number, unsigned rs1) {
  return csr_word(2, rd, number, rs1);
}
constexpr std::uint32_t csrrc(unsigned rd, std::uint32_t number, unsigned rs1) {
  return csr_word(3, rd, number, rs1);
}
constexpr std::uint32_t csrrwi(unsigned rd, std::uint32_t number, unsigned value) {
  return csr_word(5, rd, number, value);
}
constexpr std::uint32_t csrrsi(unsigned rd, std::uint32_t number, unsigned value) {
  return csr_word(6, rd, number, value);
}
constexpr std::uint32_t csrrci(unsigned rd, std::uint32_t number, unsigned value) {
  return csr_word(7, rd, number, value);
}
constexpr std::uint32_t number(Csr csr) {
  return static_cast<std::uint32_t>(csr);
}

}  // namespace gnomon::sim::cpu::test
