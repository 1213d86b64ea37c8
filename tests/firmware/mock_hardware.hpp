// SPDX-License-Identifier: Apache-2.0
// Registers and rings that behave as docs/system.md says, with the golden model inside, and faults on demand.
#pragma once

#include <cstdint>
#include <deque>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "sim/system/device_registers.hpp"

namespace gnomon::firmware::test {

/// DRAM, from the address that all sides use.
struct Dram {
  static constexpr std::uint32_t kBase = 0x80000000, kBytes = 1U << 22U;
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(kBytes);

  bool holds(std::uint64_t address, std::uint64_t size) const {
    return address >= kBase && size <= kBytes && address - kBase <= kBytes - size;
  }
  std::uint64_t word(std::uint64_t address) const;
  void set_word(std::uint64_t address, std::uint64_t value);
};

/// What the hardware does with a descriptor, other than what it should.
struct Misbehaviour {
  std::uint32_t error = 0;    ///< stops with this code, half of the results written
  std::uint32_t address = 0;  ///< of that error
  bool never_ends = false;    ///< takes it, and nothing more is heard
  std::uint32_t flags = 0;    ///< raises these sticky flags
};

class MockHardware {
 public:
  explicit MockHardware(Dram& dram);

  /// 32-bit accesses of software; false or nothing: SLVERR.
  std::optional<std::uint32_t> read(std::uint32_t offset) const { return registers.read(offset); }
  bool write(std::uint32_t offset, std::uint32_t value);
  /// Time passes, a descriptor is finished kCycles after it was begun.
  void advance(std::uint64_t cycles);
  bool interrupt() const { return registers.interrupt(); }

  static constexpr std::uint64_t kCycles = 500;

  std::deque<Misbehaviour> plan;  ///< for the next descriptors; then all is well
  bool reset_never_ends = false;
  sim::system::DeviceRegisters registers;
  std::uint64_t resets = 0;

 private:
  std::uint32_t get(std::uint32_t offset) const { return registers.get(offset); }
  void reset();
  void begin();
  void execute(std::uint64_t from, std::uint32_t words);
  void finish();
  void deliver();
  void complete();
  void stop(std::uint32_t code, std::uint32_t address);

  Dram& dram_;
  std::unique_ptr<golden::Engine> engine_;
  std::optional<std::uint64_t> ends_in_;  ///< cycles until the descriptor under way is executed
  std::deque<golden::Word> waiting_;      ///< results that are not in memory yet
  Misbehaviour misbehaviour_;
  std::uint32_t errors_ = 0, flags_ = 0;
  std::uint16_t job_ = 0;
  bool executed_ = false;  ///< the descriptor under way; its results are being written
  bool blocked_ = false;   ///< for lack of room, and said so
};

}  // namespace gnomon::firmware::test
