// SPDX-License-Identifier: Apache-2.0
// The table of cycles and what it is asked for.
#include <bit>
#include <gnomon/golden/cycles.hpp>
#include <numeric>

namespace gnomon::golden {
namespace {

constexpr std::array<const char*, kPasses> kPassNames{"IDLE", "CONTROL", "CLEAR", "PROJECT", "RESOLVE",
                                                      "READ", "DRAW",    "FILL",  "COVER",   "QUERY"};
constexpr std::array<const char*, kCauses> kCauseNames{"BUSY",        "INPUT_STARVED", "OUTPUT_BLOCKED",
                                                       "MEMORY_WAIT", "HAZARD",        "IDLE"};
constexpr int kMostLatency = 64, kMostDividers = 3;
constexpr int kLeastCacheLog2 = 12, kMostCacheLog2 = 16, kLeastAxiBits = 64, kMostAxiBits = 512;
constexpr int kLeastLineIdsLog2 = 3, kMostLineIdsLog2 = 5;

}  // namespace

std::optional<std::string> HardwareTiming::check() const {
  if (memory_latency < 1 || memory_latency > kMostLatency)
    return "MEM_LATENCY = " + std::to_string(memory_latency) + " is not in 1.." +
           std::to_string(kMostLatency);
  if (slb_dividers < 1 || slb_dividers > kMostDividers)
    return "SLB_DIVIDERS = " + std::to_string(slb_dividers) + " is not in 1.." +
           std::to_string(kMostDividers);
  return system ? system->check() : std::nullopt;
}

std::optional<std::string> SystemTiming::check() const {
  if (cache_log2 != 0 && (cache_log2 < kLeastCacheLog2 || cache_log2 > kMostCacheLog2))
    return "CACHE_LOG2 = " + std::to_string(cache_log2) + " is neither 0 nor in 12..16";
  if (line_ids_log2 < kLeastLineIdsLog2 || line_ids_log2 > kMostLineIdsLog2)
    return "LINE_IDS_LOG2 = " + std::to_string(line_ids_log2) + " is not in 3..5";
  if (axi_data_bits < kLeastAxiBits || axi_data_bits > kMostAxiBits ||
      !std::has_single_bit(static_cast<unsigned>(axi_data_bits)))
    return "AXI_DATA_BITS = " + std::to_string(axi_data_bits) + " is none of 64, 128, 256, 512";
  if (banks == 0 || row_bytes == 0 || bytes_per_cycle == 0) return "DRAM without banks, rows or data bus";
  return std::nullopt;
}

std::uint64_t CycleTable::of(Pass pass) const {
  const auto first = cells_.begin() + static_cast<std::ptrdiff_t>(index(pass, Cause::Busy));
  return std::accumulate(first, first + static_cast<std::ptrdiff_t>(kCauses), std::uint64_t{0});
}

std::uint64_t CycleTable::total() const {
  return std::accumulate(cells_.begin(), cells_.end(), std::uint64_t{0});
}

std::map<std::string, std::uint64_t> CycleTable::named() const {
  std::map<std::string, std::uint64_t> cells;
  for (std::size_t pass = 0; pass < kPasses; ++pass)
    for (std::size_t cause = 0; cause < kCauses; ++cause)
      cells[std::string("cycles.") + kPassNames[pass] + "." + kCauseNames[cause]] =
          cells_[pass * kCauses + cause];
  return cells;
}

}  // namespace gnomon::golden
