// SPDX-License-Identifier: Apache-2.0
// Cycles and SystemC's time.
#pragma once

#include <cstdint>
#include <systemc>

namespace gnomon::sim::system {

inline sc_core::sc_time cycles(std::uint64_t count) {
  return static_cast<double>(count) * sc_core::sc_time(10, sc_core::SC_NS);
}
/// Rounded up.
inline std::uint64_t to_cycles(const sc_core::sc_time& time) {
  const std::uint64_t cycle = cycles(1).value();
  return (time.value() + cycle - 1) / cycle;
}

}  // namespace gnomon::sim::system
