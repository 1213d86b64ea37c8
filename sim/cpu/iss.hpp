// SPDX-License-Identifier: Apache-2.0
// What a simulated processor does. The system knows this interface alone (docs/cpu.md).
#pragma once

#include <array>
#include <cstdint>

namespace gnomon::sim::cpu {

/// Interrupt lines of machine mode; the values are the manual's cause numbers.
enum class Interrupt : std::uint8_t { Software = 3, Timer = 7, External = 11 };

struct HartState {
  std::array<std::uint32_t, 32> x{};  ///< x[0] is 0
  std::uint32_t pc = 0;
  bool operator==(const HartState&) const = default;
};

/// Since reset; software cannot change them.
struct Counters {
  std::uint64_t cycles = 0;
  std::uint64_t instructions = 0;   ///< that retired
  std::uint64_t cycles_asleep = 0;  ///< in wfi; part of cycles
  std::uint64_t cycles_waited = 0;  ///< for the bus; part of cycles
  std::uint64_t loads = 0, stores = 0;
  std::uint64_t exceptions = 0, interrupts = 0;  ///< taken
  bool operator==(const Counters&) const = default;
};

enum class Stop : std::uint8_t {
  Budget,     ///< all the instructions asked for
  Asleep,     ///< in wfi; nothing happens before an interrupt line rises
  Requested,  ///< request_stop was called
};

class Iss {
 public:
  virtual ~Iss() = default;

  /// As after power-up: registers 0, pc at the reset address, interrupts off, counters 0. Lines stay.
  virtual void reset() = 0;
  /// Executes up to `instructions`, one that traps counts as one.
  virtual Stop run(std::uint64_t instructions) = 0;
  virtual void set_interrupt(Interrupt line, bool level) = 0;
  /// Time in which the hart did nothing: asleep, or held by its owner.
  virtual void pass_time(std::uint64_t cycles) = 0;
  /// Ends the current run after the instruction under way (or the next run before its first).
  virtual void request_stop() = 0;

  virtual HartState state() const = 0;
  virtual void set_state(const HartState& state) = 0;
  virtual Counters counters() const = 0;
};

}  // namespace gnomon::sim::cpu
