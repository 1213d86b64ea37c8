// SPDX-License-Identifier: Apache-2.0
// Our processor and the oracle, one instruction after the other, compared after each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/cpu/rv32_core.hpp"
#include "tests/sim/cpu/flat_memory.hpp"
#include "tests/sim/cpu/unicorn_cpu.hpp"
#include "tests/support/random.hpp"

namespace gnomon::sim::cpu::test {

using stimulus::Random;

class Lockstep {
 public:
  explicit Lockstep(InstructionTable table = rv32imc());

  void put_code(std::uint32_t address, std::span<const std::uint8_t> bytes);
  void fill_data(Random& random);
  void set_state(const HartState& state);
  HartState state() const { return oracle_.state(); }
  /// One instruction on both; what differs, if anything. An instruction that traps changes nothing else.
  std::optional<std::string> step();
  /// All of the data memory.
  std::optional<std::string> compare_data();
  std::uint32_t code_word(std::uint32_t address) const;

  std::uint64_t compared = 0;  ///< instructions
  Outcome last = Outcome::Done;

 private:
  Outcome step_core();
  FlatMemory memory_;
  Rv32Core core_;
  UnicornCpu oracle_;
};

/// A value, often one at the end of some range of numbers.
std::uint32_t edge_value(Random& random);
/// All registers, edge values among them.
HartState random_state(Random& random, std::uint32_t pc);
/// A word that matches the row (and no row before it, if at all possible).
std::uint32_t random_word(const InstructionRow& row, Random& random);

bool is_load(Op op);
bool is_store(Op op);
/// Bytes of a load or store.
unsigned access_size(Op op);
/// Sets the base register so that the access is aligned and meets the data; false if that cannot be (x0).
bool aim_at_data(HartState& state, const Instruction& instruction, Random& random);

/// Places `word`, which may be 16 or 32 bits, somewhere in the code and runs it from a random state.
/// What differs, if anything.
std::optional<std::string> try_word(Lockstep& both, std::uint32_t word, Random& random);

std::string describe(const HartState& ours, const HartState& oracle);

}  // namespace gnomon::sim::cpu::test
