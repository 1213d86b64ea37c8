// SPDX-License-Identifier: Apache-2.0
// An RV32IMC hart in machine mode (docs/cpu.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/cpu/bus.hpp"
#include "sim/cpu/csr_file.hpp"
#include "sim/cpu/instruction.hpp"
#include "sim/cpu/iss.hpp"

namespace gnomon::sim::cpu {

/// Cycles of an instruction, without the bus's wait cycles.
struct CycleCosts {
  std::uint32_t simple = 1, load_store = 2, jump = 2, branch_taken = 3, multiply = 1, multiply_high = 2,
                divide = 37, trap_entry = 4;
};

class Rv32Core final : public Iss {
 public:
  /// The bus must outlive the core. Another table makes another processor; tests plant faults with it.
  explicit Rv32Core(Bus& bus, std::uint32_t reset_address = 0, InstructionTable table = rv32imc());

  void reset() override;
  Stop run(std::uint64_t instructions) override;
  void set_interrupt(Interrupt line, bool level) override;
  void pass_time(std::uint64_t cycles) override;
  void request_stop() override { stop_requested_ = true; }
  HartState state() const override { return {x_, pc_}; }
  void set_state(const HartState& state) override;
  Counters counters() const override { return counters_; }
  /// A register as the next instruction would read it; nothing where there is none.
  std::optional<std::uint32_t> csr(std::uint32_t number) const { return csr_.read(number, counters_); }

 private:
  struct CachedInstruction {
    std::uint32_t address = kNoAddress;
    Instruction instruction;
  };
  static constexpr std::uint32_t kNoAddress = 1;  // no instruction has an odd one

  void step();
  /// Null after a fault, which has been taken.
  const Instruction* fetch();
  std::optional<std::uint32_t> fetch_half(std::uint32_t address);
  void execute(const Instruction& instruction);
  CachedInstruction& cached(std::uint32_t address);
  void forget(std::uint32_t address, unsigned bytes);
  void forget_all();

  void retire(std::uint32_t next_pc, std::uint32_t cycles);
  /// rd = value, and on to the next instruction.
  void finish(const Instruction& instruction, std::uint32_t value, std::uint32_t cycles);
  void branch(const Instruction& instruction, bool taken);
  void jump(const Instruction& instruction, std::uint32_t target);
  template <class T>
  void load(const Instruction& instruction);
  void store(const Instruction& instruction, unsigned bytes);
  /// One of the six, with the register's or the immediate's value.
  void access_csr(const Instruction& instruction);
  void sleep(const Instruction& instruction);
  void raise(Cause cause, std::uint32_t value);
  void take_interrupt();

  void set_x(unsigned index, std::uint32_t value) {
    x_[index] = value;
    x_[0] = 0;
  }
  void wait(const Reply& reply) {
    counters_.cycles += reply.wait_cycles;
    counters_.cycles_waited += reply.wait_cycles;
  }

  Bus& bus_;
  InstructionTable table_;
  std::uint32_t reset_address_;
  CycleCosts costs_;
  std::array<std::uint32_t, 32> x_{};
  std::uint32_t pc_ = 0;
  CsrFile csr_;
  Counters counters_;
  bool asleep_ = false;
  bool stop_requested_ = false;
  std::vector<CachedInstruction> cache_;
};

}  // namespace gnomon::sim::cpu
