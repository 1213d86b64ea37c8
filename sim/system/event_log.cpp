// SPDX-License-Identifier: Apache-2.0
// Nothing in it needs quoting: names are ours.
#include "sim/system/event_log.hpp"

#include <fmt/format.h>

namespace gnomon::sim::system {

std::string to_json(const TransactionEvent& e) {
  return fmt::format(
      R"({{"event":"transaction","begin":{},"end":{},"initiator":"{}","target":"{}","write":{},"address":"0x{:x}","bytes":{},"answer":"{}"}})",
      e.begin, e.end, e.initiator, e.target, e.write, e.address, e.bytes, e.answer);
}

std::string to_json(const InterruptEvent& e) {
  return fmt::format(R"({{"event":"interrupt","cycle":{},"line":"{}","level":{}}})", e.cycle, e.line,
                     e.level);
}

std::string to_json(const DescriptorEvent& e) {
  return fmt::format(
      R"({{"event":"descriptor","cycle":{},"job":{},"words":{},"flags":{},"address":"0x{:x}"}})", e.cycle,
      e.job, e.words, e.flags, e.address);
}

}  // namespace gnomon::sim::system
