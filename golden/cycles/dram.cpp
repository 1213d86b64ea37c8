// SPDX-License-Identifier: Apache-2.0
// Banks with an open row each, one data bus behind them.
#include "dram.hpp"

#include <algorithm>

namespace gnomon::golden::cycles {

DramClock::DramClock(const SystemTiming& timing) : timing_(timing), banks_(timing.banks) {}

void DramClock::open(std::uint64_t address) {
  const std::uint64_t row = address / timing_.row_bytes;
  banks_[row % banks_.size()].row = row;
}

Cycle DramClock::access(Cycle cycle, std::uint64_t address, std::uint64_t bytes) {
  const Cycle arrived = cycle + timing_.bus_latency;
  while (bytes != 0) {
    const std::uint64_t in_row =
        std::min<std::uint64_t>(bytes, timing_.row_bytes - address % timing_.row_bytes);
    move(arrived, address, in_row);
    address += in_row;
    bytes -= in_row;
  }
  return std::max(data_free_ + timing_.latency, cycle + 1);
}

void DramClock::move(Cycle arrived, std::uint64_t address, std::uint64_t bytes) {
  const std::uint64_t row = address / timing_.row_bytes;
  Bank& bank = banks_[row % banks_.size()];
  Cycle opened = std::max(arrived, bank.free);
  if (bank.row != row) opened += timing_.rcd + (bank.row == kClosed ? 0 : timing_.rp);
  bank.row = row;
  bank.free = opened + timing_.cas;
  data_free_ =
      std::max(bank.free, data_free_) + (bytes + timing_.bytes_per_cycle - 1) / timing_.bytes_per_cycle;
}

}  // namespace gnomon::golden::cycles
