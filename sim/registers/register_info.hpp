// SPDX-License-Identifier: Apache-2.0
// What is known of a register besides its name (docs/registers.md).
#pragma once

#include <cstdint>
#include <string_view>

namespace gnomon::sim::registers {

enum class Access : std::uint8_t {
  Ro,   ///< writes are ignored
  Rw,   ///< reads back
  W1c,  ///< writing 1 clears a bit
  W1p,  ///< writing 1 starts something
};

struct RegisterInfo {
  std::string_view name;
  std::uint32_t offset;
  std::uint32_t count, stride;  ///< of an array; 1 and 4 of a single register
  Access access;
  std::uint32_t reset;  ///< 0 where it depends on the build
  std::uint32_t mask;   ///< bits that exist
};

}  // namespace gnomon::sim::registers
