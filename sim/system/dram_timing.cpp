// SPDX-License-Identifier: Apache-2.0
// Rows, columns, data.
#include "sim/system/dram_timing.hpp"

#include <algorithm>
#include <stdexcept>

namespace gnomon::sim::system {

DramTiming::DramTiming(const DramConfig& config) : config_(config), banks_(config.banks) {
  if (config.banks == 0 || config.row_bytes == 0 || config.bytes_per_cycle == 0)
    throw std::invalid_argument("DRAM without banks, rows or data bus");
}

std::uint64_t DramTiming::access(std::uint64_t cycle, std::uint64_t address, std::uint64_t bytes,
                                 bool write) {
  (write ? statistics_.writes : statistics_.reads) += 1;
  statistics_.bytes += bytes;
  std::uint64_t done = cycle;
  while (bytes != 0) {
    const std::uint64_t part =
        std::min<std::uint64_t>(bytes, config_.row_bytes - address % config_.row_bytes);
    done = access_row(cycle, address, part);
    address += part;
    bytes -= part;
  }
  return done + config_.latency;
}

std::uint64_t DramTiming::open_row(Bank& bank, std::uint64_t row) {
  if (bank.row == row) {
    ++statistics_.row_hits;
    return 0;
  }
  const bool empty = !bank.row.has_value();
  bank.row = row;
  ++(empty ? statistics_.rows_opened : statistics_.row_conflicts);
  return empty ? config_.t_rcd : config_.t_rp + config_.t_rcd;
}

std::uint64_t DramTiming::access_row(std::uint64_t cycle, std::uint64_t address, std::uint64_t bytes) {
  const std::uint64_t row = address / config_.row_bytes;
  Bank& bank = banks_[row % banks_.size()];
  const std::uint64_t start = std::max(cycle, bank.free);
  bank.free = start + open_row(bank, row / banks_.size()) + config_.t_cas;
  const std::uint64_t moving = (bytes + config_.bytes_per_cycle - 1) / config_.bytes_per_cycle;
  bus_free_ = std::max(bank.free, bus_free_) + moving;
  statistics_.bus_cycles += moving;
  return bus_free_;
}

}  // namespace gnomon::sim::system
