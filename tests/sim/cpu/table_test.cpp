// SPDX-License-Identifier: Apache-2.0
// The instruction table: complete, and no row hides another by accident.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "sim/cpu/instruction.hpp"

namespace gnomon::sim::cpu::test {
namespace {

std::set<std::string> names(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::set<std::string> result;
  for (std::string word; words >> word;) result.insert(word);
  return result;
}
std::set<std::string> names(std::span<const InstructionRow> rows) {
  std::set<std::string> result;
  for (const InstructionRow& row : rows) result.insert(std::string(row.name));
  return result;
}

// From the manual's instruction set listings.
TEST(InstructionTable, HoldsTheManualsInstructions) {
  EXPECT_EQ(names(rv32imc().words),
            names("lui auipc jal jalr beq bne blt bge bltu bgeu lb lh lw lbu lhu sb sh sw addi slti sltiu "
                  "xori ori andi "
                  "slli srli srai add sub sll slt sltu xor srl sra or and fence ecall ebreak fence.i csrrw "
                  "csrrs csrrc "
                  "csrrwi csrrsi csrrci mul mulh mulhsu mulhu div divu rem remu mret wfi"));
  EXPECT_EQ(names(rv32imc().halves),
            names("reserved c.addi4spn c.lw c.sw c.addi c.jal c.li c.addi16sp c.lui c.srli c.srai c.andi "
                  "c.sub c.xor c.or "
                  "c.and c.j c.beqz c.bnez c.slli c.lwsp c.jr c.mv c.ebreak c.jalr c.add c.swsp"));
}

bool overlap(const InstructionRow& a, const InstructionRow& b) {
  return ((a.match ^ b.match) & a.mask & b.mask) == 0;
}
/// All words of `inner` are words of `outer`.
bool within(const InstructionRow& inner, const InstructionRow& outer) {
  return overlap(inner, outer) && (inner.mask & outer.mask) == outer.mask && inner.mask != outer.mask;
}

int carved_out(std::span<const InstructionRow> rows) {
  int count = 0;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      if (!overlap(rows[i], rows[j])) continue;
      // c.lui x2 is c.addi16sp: their reserved row is cut out of both.
      const bool both = rows[i].name == "reserved" && rows[j].name == "c.addi16sp";
      EXPECT_TRUE(within(rows[i], rows[j]) || both) << rows[i].name << " hides " << rows[j].name;
      ++count;
    }
  return count;
}

TEST(InstructionTable, SpecialFormsStandAboveGeneralOnes) {
  EXPECT_EQ(carved_out(rv32imc().words), 0);
  // addi4spn; addi16sp twice, lui; lwsp; reserved over jr over mv; ebreak over jalr over add.
  EXPECT_EQ(carved_out(rv32imc().halves), 11);
}

TEST(InstructionTable, RowsHaveTheLengthThatTheirLowBitsSay) {
  for (const InstructionRow& row : rv32imc().words)
    EXPECT_TRUE((row.mask & 3U) == 3 && is_long(row.match)) << row.name;
  for (const InstructionRow& row : rv32imc().halves)
    EXPECT_TRUE((row.mask & 3U) == 3 && !is_long(row.match) && row.mask <= 0xFFFF) << row.name;
}

TEST(InstructionTable, ImmediatesReachTheirEnds) {
  const auto immediate = [](std::uint32_t word) { return decode(rv32imc(), word).operands.imm; };
  EXPECT_EQ(immediate(0x8000006F), -(1 << 20)) << "jal";
  EXPECT_EQ(immediate(0x7FFFF06F), (1 << 20) - 2);
  EXPECT_EQ(immediate(0x80000063), -4096) << "beq";
  EXPECT_EQ(immediate(0x7E000FE3), 4094);
  EXPECT_EQ(immediate(0x80000023), -2048) << "sb";
  EXPECT_EQ(immediate(0x7E000FA3), 2047);
  EXPECT_EQ(immediate(0x80000003), -2048) << "lb";
  EXPECT_EQ(immediate(0x80000037), -2147483647 - 1) << "lui";
  EXPECT_EQ(immediate(0xB001), -2048) << "c.j";
  EXPECT_EQ(immediate(0x7101), -512) << "c.addi16sp";
}

}  // namespace
}  // namespace gnomon::sim::cpu::test
