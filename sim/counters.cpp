// SPDX-License-Identifier: Apache-2.0
// Names to indices.
#include "sim/counters.hpp"

#include <span>
#include <string>

#include "sim/counter_names.hpp"

namespace gnomon::sim {

golden::Counters read_counters(const golden::HardwareConfig& config,
                               const std::function<std::uint64_t(std::uint32_t index)>& counter) {
  golden::Counters counters;
  const auto add_events = [&](std::uint32_t first, std::span<const std::string_view> names) {
    for (std::uint32_t i = 0; i < names.size(); ++i)
      counters.events[std::string(names[i])] = counter(first + i);
  };
  add_events(0, kEventNames);
  if (config.en_slb) add_events(kFirstSlbCounter, kSlbEventNames);
  if (config.en_vpu_topology) add_events(kFirstTopologyCounter, kTopologyEventNames);
  const std::span<const std::string_view> perspective(kPerspectiveEventNames);
  if (config.en_perspective)
    add_events(kFirstPerspectiveCounter,
               config.en_vpu_topology ? perspective : perspective.first(kPerspectiveOffsetEvents));
  if (config.en_frame_buffer) add_events(kFirstFrameCounter, kFrameEventNames);
  for (std::size_t pass = 0; pass < kPassNames.size(); ++pass) {
    for (std::size_t cause = 0; cause < kCauseNames.size(); ++cause) {
      counters.cycles[cycle_counter_name(pass, cause)] = counter(cycle_counter_index(pass, cause));
    }
  }
  return counters;
}

std::map<std::string, std::uint64_t> read_cache_counters(
    const std::function<std::uint64_t(std::uint32_t index)>& counter) {
  std::map<std::string, std::uint64_t> counters;
  for (std::size_t memory = 0; memory < kCacheMemoryNames.size(); ++memory) {
    const auto value = [&](CacheEvent event) { return counter(cache_counter_index(memory, event)); };
    if (value(CacheEvent::Hits) + value(CacheEvent::Misses) == 0) continue;
    for (std::size_t event = 0; event < kCacheEventNames.size(); ++event)
      counters[cache_counter_name(memory, event)] = value(static_cast<CacheEvent>(event));
  }
  return counters;
}

golden::Counters operator-(golden::Counters now, const golden::Counters& before) {
  for (const auto& [name, count] : before.events) now.events[name] -= count;
  for (const auto& [name, count] : before.cycles) now.cycles[name] -= count;
  return now;
}

}  // namespace gnomon::sim
