// SPDX-License-Identifier: Apache-2.0
// What the buffer and a shadow map cost.
#include "host/slb/costs.hpp"

#include <string>
#include <string_view>

namespace gnomon::slb {
namespace {

constexpr double kPixelsPerCycle = 16;       // of FILL, and of the shadow map for a fair comparison
constexpr std::uint64_t kTexelBits = 32;     // 20-bit depths in words of memory
constexpr std::uint64_t kGenerations = 255;  // a clear scrubs this share of the plane
constexpr std::uint64_t kScratchBitsPerPixel = 11, kScratchBitsPerRow = 8;

double event(const golden::Counters& counters, std::string_view name) {
  const auto found = counters.events.find(std::string(name));
  return found == counters.events.end() ? 0 : static_cast<double>(found->second);
}

double cycles_of(const golden::Counters& counters, std::string_view pass) {
  const std::string prefix = "cycles." + std::string(pass) + ".";
  double sum = 0;
  for (auto at = counters.cycles.lower_bound(prefix);
       at != counters.cycles.end() && at->first.starts_with(prefix); ++at)
    sum += static_cast<double>(at->second);
  return sum;
}

std::uint64_t pixels(const golden::HardwareConfig& config) {
  const auto side = static_cast<std::uint64_t>(config.slb_config().side());
  return side * side;
}

}  // namespace

Costs buffer_costs(const golden::HardwareConfig& config, const golden::Counters& counters) {
  const golden::slb::SlbConfig slb = config.slb_config();
  Costs costs;
  costs.memory_bits =
      pixels(config) * (static_cast<std::uint64_t>(slb.stored_entry_bits()) + kScratchBitsPerPixel) +
      static_cast<std::uint64_t>(slb.side()) * kScratchBitsPerRow;
  costs.measured = !counters.cycles.empty();
  if (costs.measured) {
    costs.draw_cycles =
        cycles_of(counters, "CLEAR") + cycles_of(counters, "DRAW") + cycles_of(counters, "FILL");
    costs.query_cycles = cycles_of(counters, "QUERY");
  } else {
    const std::uint64_t scrubbed = (pixels(config) + kGenerations - 1) / kGenerations;
    costs.draw_cycles = static_cast<double>(scrubbed) + event(counters, "SLB_CROSSINGS") +
                        event(counters, "SLB_FILL_PIXELS") / kPixelsPerCycle +
                        event(counters, "SLB_FILL_GROUPS");
    costs.query_cycles = event(counters, "SLB_QUERIES");
  }
  return costs;
}

Costs map_costs(const golden::HardwareConfig& config, const golden::Counters& counters, int finer) {
  const auto texels_per_pixel = static_cast<std::uint64_t>(finer) * static_cast<std::uint64_t>(finer);
  const std::uint64_t texels = pixels(config) * texels_per_pixel;
  // Pixels that the casters cover: wholly, or on average half where an outline runs.
  const double covered = event(counters, "SLB_FILL_COVERED") + event(counters, "SLB_FILL_GROUPS") / 2;
  Costs costs;
  costs.memory_bits = texels * kTexelBits;
  costs.draw_cycles =
      (static_cast<double>(texels) + covered * static_cast<double>(texels_per_pixel)) / kPixelsPerCycle;
  costs.query_cycles = event(counters, "SLB_QUERIES");
  return costs;
}

}  // namespace gnomon::slb
