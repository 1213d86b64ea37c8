// SPDX-License-Identifier: Apache-2.0
// The oracle: Unicorn, stepped one instruction at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/cpu/iss.hpp"

namespace gnomon::sim::cpu::test {

/// How an instruction ended.
enum class Outcome : std::uint8_t { Done, Illegal, Breakpoint, EnvironmentCall, MemoryFault, Other };

/// The memory map of FlatMemory.
class UnicornCpu {
 public:
  UnicornCpu();

  void put_code(std::uint32_t address, std::span<const std::uint8_t> bytes);
  void put_data(std::span<const std::uint8_t> bytes);
  std::vector<std::uint8_t> data(std::uint32_t address, std::uint32_t bytes) const;
  void set_state(const HartState& state);
  HartState state() const;
  Outcome step();

 private:
  struct Close {
    void operator()(void* engine) const;
  };
  std::unique_ptr<void, Close> engine_;
  std::uint32_t pc_ = 0;
};

}  // namespace gnomon::sim::cpu::test
