// SPDX-License-Identifier: Apache-2.0
// When DRAM has moved the bytes of an access (docs/system-model.md, "DRAM").
#pragma once

#include <gnomon/golden/cycles.hpp>
#include <vector>

#include "run.hpp"

namespace gnomon::golden::cycles {

class DramClock {
 public:
  explicit DramClock(const SystemTiming& timing);

  /// Opens the row of an address, in no time.
  void open(std::uint64_t address);
  /// An access that the bus takes in `cycle`; accesses come in the order of their cycles. The cycle in which
  /// its last byte has reached the requester.
  Cycle access(Cycle cycle, std::uint64_t address, std::uint64_t bytes);

 private:
  static constexpr std::uint64_t kClosed = UINT64_MAX;
  struct Bank {
    std::uint64_t row = kClosed;
    Cycle free = 0;
  };
  void move(Cycle arrived, std::uint64_t address, std::uint64_t bytes);

  SystemTiming timing_;
  std::vector<Bank> banks_;
  Cycle data_free_ = 0;
};

}  // namespace gnomon::golden::cycles
