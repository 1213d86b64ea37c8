// SPDX-License-Identifier: Apache-2.0
// When an access to DRAM is done: banks with open rows, one data bus (docs/system-model.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace gnomon::sim::system {

/// Times in cycles.
struct DramConfig {
  std::uint32_t banks = 8;
  std::uint32_t row_bytes = 2048;
  std::uint32_t t_rcd = 2, t_rp = 2, t_cas = 2;
  std::uint32_t bytes_per_cycle = 8;
  std::uint32_t latency = 20;  ///< controller and wires, both ways
};

struct DramStatistics {
  std::uint64_t reads = 0, writes = 0;  ///< accesses
  std::uint64_t bytes = 0;
  std::uint64_t row_hits = 0, rows_opened = 0, row_conflicts = 0;  ///< opened: in an empty bank
  std::uint64_t bus_cycles = 0;
  bool operator==(const DramStatistics&) const = default;
};

class DramTiming {
 public:
  /// Throws std::invalid_argument if a count or size is 0.
  explicit DramTiming(const DramConfig& config);

  /// The cycle at which the last byte has reached the requester.
  std::uint64_t access(std::uint64_t cycle, std::uint64_t address, std::uint64_t bytes, bool write);
  const DramStatistics& statistics() const { return statistics_; }

 private:
  struct Bank {
    std::optional<std::uint64_t> row;
    std::uint64_t free = 0;
  };
  /// Within a row; when its data has left the data bus.
  std::uint64_t access_row(std::uint64_t cycle, std::uint64_t address, std::uint64_t bytes);
  std::uint64_t open_row(Bank& bank, std::uint64_t row);

  DramConfig config_;
  std::vector<Bank> banks_;
  std::uint64_t bus_free_ = 0;
  DramStatistics statistics_;
};

}  // namespace gnomon::sim::system
