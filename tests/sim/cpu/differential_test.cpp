// SPDX-License-Identifier: Apache-2.0
// Lock step with the oracle: every row, every 16-bit encoding, every function code, random programs; and
// cores with a wrong row in their table, which must be noticed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "tests/sim/cpu/lockstep.hpp"
#include "tests/sim/cpu/random_program.hpp"

namespace gnomon::sim::cpu::test {
namespace {

using Rows = std::vector<InstructionRow>;

/// Not compared: what the oracle has no answer for (machine mode, counters) or answers for more than we have.
bool comparable(const InstructionRow& row) {
  return row.op != Op::Mret && row.op != Op::Wfi && (row.op < Op::Csrrw || row.op > Op::Csrrci);
}

std::vector<InstructionRow> all_rows() {
  Rows rows;
  for (const InstructionRow& row : rv32imc().words) rows.push_back(row);
  for (const InstructionRow& row : rv32imc().halves) rows.push_back(row);
  return rows;
}

std::optional<std::string> try_row(Lockstep& both, const InstructionRow& row, Random& random, int times) {
  for (int i = 0; i < times; ++i)
    if (auto difference = try_word(both, random_word(row, random), random)) return difference;
  return both.compare_data();
}

TEST(Differential, EveryInstructionWithEdgeValues) {
  constexpr int kTimes = 500;
  Lockstep both;
  Random random(1);
  both.fill_data(random);
  std::uint64_t rows = 0;
  for (const InstructionRow& row : all_rows()) {
    if (!comparable(row)) continue;
    ++rows;
    EXPECT_EQ(try_row(both, row, random, kTimes), std::nullopt) << row.name;
  }
  EXPECT_EQ(rows, 49u + 30u);
  EXPECT_EQ(both.compared, rows * kTimes);
}

/// What the oracle executes and RV32C without floating point does not have.
bool only_the_oracle_has(std::uint32_t half) {
  const std::uint32_t quadrant = half & 3U, function = half >> 13U;
  const bool floating_point = quadrant != 1 && (function & 1U) != 0;
  const bool reserved = quadrant == 0 && function == 4;
  const bool bit12 = (half >> 12U & 1U) != 0;
  const bool long_shift = bit12 && ((quadrant == 2 && function == 0) ||
                                    (quadrant == 1 && function == 4 && (half >> 11U & 1U) == 0));
  const bool reserved_arithmetic = bit12 && quadrant == 1 && function == 4 && (half >> 10U & 3U) == 3;
  return floating_point || reserved || long_shift || reserved_arithmetic;
}

TEST(Differential, EveryHalfWord) {
  Lockstep both;
  Random random(2);
  both.fill_data(random);
  std::uint64_t refused = 0, left_out = 0;
  for (std::uint32_t half = 0; half <= 0xFFFF; ++half) {
    if (is_long(half)) continue;
    if (only_the_oracle_has(half)) {
      ++left_out;
      EXPECT_EQ(decode(rv32imc(), half).op, Op::Illegal) << std::hex << half;
      continue;
    }
    ASSERT_EQ(try_word(both, half, random), std::nullopt) << std::hex << half;
    refused += both.last == Outcome::Illegal ? 1U : 0U;
  }
  EXPECT_EQ(both.compare_data(), std::nullopt);
  EXPECT_EQ(left_out, 16'384u + 2'048 + 1'024 + 512 + 256);
  EXPECT_EQ(both.compared + left_out, 49'152u);
  EXPECT_EQ(refused,
            8u + 32 + 64 + 1);  // addi4spn of 0; lui and addi16sp of 0; lwsp to x0; jr to x0
}

TEST(Differential, EveryFunctionCode) {
  Lockstep both;
  Random random(3);
  both.fill_data(random);
  std::uint64_t legal = 0;
  for (const std::uint32_t opcode : {0x03U, 0x23U, 0x63U, 0x67U, 0x6FU, 0x13U, 0x33U, 0x37U, 0x17U})
    for (std::uint32_t function = 0; function < 8 * 128; ++function) {
      const std::uint32_t operands = static_cast<std::uint32_t>(random.bits()) & 0x01FF8F80U;
      const std::uint32_t word = (function & 127U) << 25U | operands | function >> 7U << 12U | opcode;
      ASSERT_EQ(try_word(both, word, random), std::nullopt) << std::hex << word;
      legal += both.last == Outcome::Illegal ? 0U : 1U;
    }
  EXPECT_EQ(both.compared, 9u * 1024u);
  // loads 5, stores 3, branches 6, jalr 1, jal 8, lui 8, auipc 8, immediates 6 of 8 functions, whole; shifts
  // and register operations by function code.
  EXPECT_EQ(legal, (5u + 3 + 6 + 1 + 8 + 8 + 8 + 6) * 128 + 3 + 18);
}

TEST(Differential, RandomPrograms) {
  Lockstep both;
  Random random(4);
  both.fill_data(random);
  std::map<Op, int> executed;
  std::uint64_t steps = 0;
  for (int program = 0; program < 300; ++program) {
    const ProgramRun run = run_random_program(both, random, 250, executed);
    ASSERT_EQ(run.difference, std::nullopt) << "program " << program;
    steps += run.steps;
  }
  EXPECT_EQ(both.compare_data(), std::nullopt);
  EXPECT_EQ(both.compared, steps);
  EXPECT_GT(steps, 30'000u);
  for (const InstructionRow& row : all_rows()) {
    if (!comparable(row) || row.op == Op::Illegal || row.op == Op::Ecall || row.op == Op::Ebreak) continue;
    EXPECT_GT(executed[row.op], 0) << row.name;
  }
}

/// The next row of the same format with another operation; else an illegal instruction.
Op another_operation(const Rows& rows, std::size_t index) {
  const InstructionRow& row = rows[index];
  if (row.op == Op::Illegal) return Op::Addi;
  // Without operands there is nothing to see but the trap.
  if (row.op == Op::Fence || row.op == Op::FenceI) return Op::Ecall;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const InstructionRow& other = rows[(index + i) % rows.size()];
    if (other.operands == row.operands && other.op != row.op && other.op != Op::Illegal) return other.op;
  }
  return Op::Illegal;
}

bool notices(const Rows& words, const Rows& halves, const InstructionRow& row) {
  Lockstep both({words, halves});
  Random random(5);
  both.fill_data(random);
  return try_row(both, row, random, 60).has_value();
}

TEST(Differential, NoticesEveryWrongRow) {
  Rows words(rv32imc().words.begin(), rv32imc().words.end());
  Rows halves(rv32imc().halves.begin(), rv32imc().halves.end());
  int tried = 0;
  for (Rows* rows : {&words, &halves})
    for (std::size_t i = 0; i < rows->size(); ++i) {
      const InstructionRow right = (*rows)[i];
      if (!comparable(right)) continue;
      (*rows)[i].op = another_operation(*rows, i);
      EXPECT_TRUE(notices(words, halves, right)) << right.name;
      (*rows)[i] = right;
      ++tried;
    }
  EXPECT_EQ(tried, 49 + 30);
}

TEST(Differential, NoticesAFaultInOperands) {
  // sltiu, whose immediate is sign-extended first, with the immediate of a shift.
  Rows words(rv32imc().words.begin(), rv32imc().words.end());
  Rows halves(rv32imc().halves.begin(), rv32imc().halves.end());
  const auto find = [&](std::string_view name) {
    return std::find_if(words.begin(), words.end(),
                        [&](const InstructionRow& row) { return row.name == name; });
  };
  const InstructionRow right = *find("sltiu");
  find("sltiu")->operands = find("slli")->operands;
  EXPECT_TRUE(notices(words, halves, right));
}

TEST(Differential, ComparesMemory) {
  // sh that stores a word shows in memory alone.
  Rows words(rv32imc().words.begin(), rv32imc().words.end());
  Rows halves(rv32imc().halves.begin(), rv32imc().halves.end());
  const auto row =
      std::find_if(words.begin(), words.end(), [](const InstructionRow& r) { return r.name == "sb"; });
  const InstructionRow right = *row;
  row->op = Op::Sh;
  Lockstep both({words, halves});
  Random random(6);
  both.fill_data(random);
  HartState state = random_state(random, kCodeBase);
  state.x[5] = kDataBase + 16;
  state.x[6] = 0x1234;
  const std::uint32_t word = right.match | 6U << 20U | 5U << 15U;
  std::array<std::uint8_t, 8> code{0, 0, 0, 0, 0x6F};
  std::memcpy(code.data(), &word, 4);
  both.put_code(kCodeBase, code);
  both.set_state(state);
  EXPECT_EQ(both.step(), std::nullopt);
  EXPECT_NE(both.compare_data(), std::nullopt);
}

}  // namespace
}  // namespace gnomon::sim::cpu::test
