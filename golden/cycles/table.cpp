// SPDX-License-Identifier: Apache-2.0
// The table of cycles and what it is asked for.
#include <gnomon/golden/cycles.hpp>
#include <numeric>

namespace gnomon::golden {
namespace {

constexpr std::array<const char*, kPasses> kPassNames{"IDLE", "CONTROL", "CLEAR", "PROJECT", "RESOLVE",
                                                      "READ", "DRAW",    "FILL",  "COVER",   "QUERY"};
constexpr std::array<const char*, kCauses> kCauseNames{"BUSY",        "INPUT_STARVED", "OUTPUT_BLOCKED",
                                                       "MEMORY_WAIT", "HAZARD",        "IDLE"};
constexpr int kMostLatency = 64, kMostDividers = 3;

}  // namespace

std::optional<std::string> HardwareTiming::check() const {
  if (memory_latency < 1 || memory_latency > kMostLatency)
    return "MEM_LATENCY = " + std::to_string(memory_latency) + " is not in 1.." +
           std::to_string(kMostLatency);
  if (slb_dividers < 1 || slb_dividers > kMostDividers)
    return "SLB_DIVIDERS = " + std::to_string(slb_dividers) + " is not in 1.." +
           std::to_string(kMostDividers);
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
