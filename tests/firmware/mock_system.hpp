// SPDX-License-Identifier: Apache-2.0
// The memory map of docs/system.md: program memory, hardware, mailbox, timer, DRAM; and the host's side of
// it.
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <span>
#include <string>
#include <vector>

#include "firmware/driver/job_runner.h"
#include "sim/cpu/bus.hpp"
#include "sim/registers/register_file.hpp"
#include "tests/firmware/mock_hardware.hpp"

namespace gnomon::firmware::test {

/// Which interrupt lines are up.
struct Lines {
  bool external = false, software = false, timer = false;
};

class MockSystem : public sim::cpu::Bus {
 public:
  MockSystem();

  sim::cpu::Reply read(std::uint32_t address, unsigned bytes, sim::cpu::Access access) override;
  sim::cpu::Reply write(std::uint32_t address, unsigned bytes, std::uint32_t data) override;
  void advance(std::uint64_t cycles);
  Lines lines() const;

  /// Puts words into DRAM; their address.
  std::uint32_t place(std::span<const golden::Word> words);
  /// Fills the next place of the table and rings.
  void post(const gnomon_job& job);
  void ring();
  gnomon_job job(std::uint32_t number) const;
  std::uint32_t finished() const;
  /// Takes what is in the result ring, as RESULTS_READY says.
  void take_results();
  /// Results taken so far, from count begin to end.
  std::vector<golden::Word> results(std::uint32_t begin, std::uint32_t end) const;

  static constexpr std::uint32_t kCommandLog2 = 2, kTableLog2 = 3;
  std::uint32_t result_log2 = 13;
  void set_up();  ///< the mailbox, for the rings above

  std::vector<std::uint8_t> program = std::vector<std::uint8_t>(65536);
  Dram dram;
  MockHardware hardware{dram};
  sim::registers::RegisterFile mailbox;
  std::string log;
  std::uint64_t time = 0;
  std::uint64_t register_reads = 0, register_writes = 0;  ///< of the hardware, the mailbox and the timer

 private:
  std::uint8_t* memory(std::uint32_t address, unsigned bytes);
  sim::cpu::Reply read_register(std::uint32_t address);
  bool write_register(std::uint32_t address, std::uint32_t data);

  sim::registers::RegisterFile timer_;
  std::uint32_t next_words_;
  std::vector<golden::Word> taken_;
};

/// Where the mailbox of set_up puts things in DRAM.
inline constexpr std::uint32_t kCommandRing = Dram::kBase + 0x1000, kJobTable = Dram::kBase + 0x2000,
                               kPlanes = Dram::kBase + 0x10000, kResultRing = Dram::kBase + 0x100000,
                               kWords = Dram::kBase + 0x200000;

}  // namespace gnomon::firmware::test
