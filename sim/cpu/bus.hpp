// SPDX-License-Identifier: Apache-2.0
// What a simulated processor needs: reads and writes of 1, 2 or 4 bytes (docs/cpu.md).
#pragma once

#include <cstdint>

namespace gnomon::sim::cpu {

enum class Access : std::uint8_t { Fetch, Load };

struct Reply {
  std::uint32_t data = 0;         ///< of a read, in the low bits; the bits above are ignored
  std::uint32_t wait_cycles = 0;  ///< beyond those that every access costs
  bool fault = false;             ///< nothing there, or refused; nothing has changed
};

/// Addresses are physical and aligned to the size of the access. A device may call Iss::set_interrupt and
/// Iss::request_stop from here.
class Bus {
 public:
  virtual ~Bus() = default;
  virtual Reply read(std::uint32_t address, unsigned bytes, Access access) = 0;
  virtual Reply write(std::uint32_t address, unsigned bytes, std::uint32_t data) = 0;
};

}  // namespace gnomon::sim::cpu
