// SPDX-License-Identifier: Apache-2.0
// The system around the hardware, as metrics.json has it.
#include <algorithm>
#include <numeric>
#include <sstream>

#include "host/report/metrics_parts.hpp"

namespace gnomon::report {
namespace {

Json lines_of(const std::string& text) {
  Json lines = Json::array();
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Json firmware_json(const SystemRecord& system) {
  const sim::system::SystemStatistics& s = system.statistics;
  const std::uint64_t of_jobs =
      std::accumulate(system.jobs.begin(), system.jobs.end(), std::uint64_t{0},
                      [](std::uint64_t sum, const auto& job) { return sum + job.instructions; });
  return {{"image_bytes", system.firmware_bytes},
          {"jobs", system.jobs.size()},
          {"instructions", s.cpu.instructions},
          {"instructions_per_job", ratio(of_jobs, system.jobs.size())},
          {"cpu_cycles", s.cpu.cycles},
          {"cycles_asleep", s.cpu.cycles_asleep},
          {"asleep_share", ratio(s.cpu.cycles_asleep, s.cpu.cycles)},
          {"cycles_waited", s.cpu.cycles_waited},
          {"cycles_polling", s.cycles_polling},
          {"interrupts", s.cpu.interrupts},
          {"register_reads", s.register_reads},
          {"register_writes", s.register_writes},
          {"log", lines_of(system.log)}};
}

Json bus_json(const SystemRecord& system) {
  Json targets = Json::array();
  for (const sim::system::BusCount& bus : system.statistics.bus)
    targets.push_back(
        {{"target", bus.target}, {"reads", bus.reads}, {"writes", bus.writes}, {"bytes", bus.bytes}});
  return targets;
}

Json dram_json(const SystemRecord& system) {
  const sim::system::DramStatistics& d = system.statistics.dram;
  return {{"reads", d.reads},
          {"writes", d.writes},
          {"bytes", d.bytes},
          {"bytes_per_cycle", ratio(d.bytes, system.statistics.cycles)},
          {"row_hits", d.row_hits},
          {"rows_opened", d.rows_opened},
          {"row_conflicts", d.row_conflicts},
          {"row_hit_share", ratio(d.row_hits, d.row_hits + d.rows_opened + d.row_conflicts)},
          {"bus_cycles", d.bus_cycles},
          {"bus_share", ratio(d.bus_cycles, system.statistics.cycles)}};
}

}  // namespace

Json system_json(const std::optional<SystemRecord>& system) {
  if (!system) return nullptr;
  return {{"inside", system->hardware},         {"cycles", system->statistics.cycles},
          {"firmware", firmware_json(*system)}, {"bus", bus_json(*system)},
          {"dram", dram_json(*system)},         {"cache", Json(system->cache)}};
}

}  // namespace gnomon::report
