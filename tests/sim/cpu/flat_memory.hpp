// SPDX-License-Identifier: Apache-2.0
// Memory for processors under test: code that can be read and executed, data that can be read and written.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "sim/cpu/bus.hpp"

namespace gnomon::sim::cpu::test {

inline constexpr std::uint32_t kCodeBase = 0x10000, kCodeSize = 0x100000;
inline constexpr std::uint32_t kDataBase = 0x80000000, kDataSize = 0x4000;

/// Everything else, and writing code, is a fault.
class FlatMemory : public Bus {
 public:
  Reply read(std::uint32_t address, unsigned bytes, Access access) override {
    (access == Access::Fetch ? fetches : loads) += 1;
    const std::uint8_t* const at = find(address, bytes);
    if (at == nullptr) return {0, 0, true};
    Reply reply{0, wait_cycles, false};
    std::memcpy(&reply.data, at, bytes);
    return reply;
  }
  Reply write(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
    std::uint8_t* const at = find(address, bytes);
    if (at == nullptr || (address < kDataBase && !code_writable)) return {0, 0, true};
    std::memcpy(at, &value, bytes);
    return {0, wait_cycles, false};
  }

  void put_code(std::uint32_t address, std::span<const std::uint8_t> bytes) {
    std::memcpy(find(address, static_cast<unsigned>(bytes.size())), bytes.data(), bytes.size());
  }

  std::vector<std::uint8_t> code = std::vector<std::uint8_t>(kCodeSize);
  std::vector<std::uint8_t> data = std::vector<std::uint8_t>(kDataSize);
  bool code_writable = false;
  std::uint32_t wait_cycles = 0;
  std::uint64_t fetches = 0, loads = 0;

 private:
  std::uint8_t* find(std::uint32_t address, unsigned bytes) {
    if (address - kCodeBase <= kCodeSize - bytes) return &code[address - kCodeBase];
    if (address - kDataBase <= kDataSize - bytes) return &data[address - kDataBase];
    return nullptr;
  }
};

}  // namespace gnomon::sim::cpu::test
