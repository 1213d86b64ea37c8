// SPDX-License-Identifier: Apache-2.0
// What happens in the system, as lines of JSON (docs/system-model.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gnomon::sim::system {

/// A transaction on the bus, with the cycles of its begin and its answer.
struct TransactionEvent {
  std::uint64_t begin = 0, end = 0;
  std::string_view initiator, target;  ///< target "none": no address leads there, or a fault was injected
  bool write = false;
  std::uint64_t address = 0;
  std::uint32_t bytes = 0;
  std::string_view answer;  ///< "okay", "slverr", "decerr", "none"
};

struct InterruptEvent {
  std::uint64_t cycle = 0;
  std::string_view line;  ///< "external", "software", "timer"
  bool level = false;
};

/// A descriptor that the hardware has fetched.
struct DescriptorEvent {
  std::uint64_t cycle = 0;
  std::uint32_t job = 0, words = 0, flags = 0;
  std::uint64_t address = 0;
};

/// One line each, without the line's end.
std::string to_json(const TransactionEvent& event);
std::string to_json(const InterruptEvent& event);
std::string to_json(const DescriptorEvent& event);

}  // namespace gnomon::sim::system
