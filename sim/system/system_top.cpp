// SPDX-License-Identifier: Apache-2.0
// The host's side: jobs in, results out.
#include "sim/system/system_top.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/system/event_log.hpp"
#include "sim/system/modules/clock.hpp"
#include "sim/system/modules/hardware_module.hpp"
#include "sim/system/modules/simulation.hpp"
#include "sim/system/modules/top_module.hpp"
#include "sim/system/system_parts.hpp"

namespace gnomon::sim::system {

System::System(const SystemConfig& config, golden::Engine& engine, std::span<const std::uint8_t> firmware,
               EngineClock clock)
    : simulation_(std::make_unique<Simulation>()) {
  const Simulation::Turn turn(*simulation_);
  parts_ = std::make_unique<Parts>(config, engine.config(), firmware, [&] {
    return std::make_unique<HardwareModule>("hardware", engine, std::move(clock));
  });
}
System::System(const SystemConfig& config, TopModel& model, const golden::HardwareConfig& hardware,
               std::span<const std::uint8_t> firmware)
    : simulation_(std::make_unique<Simulation>()) {
  const Simulation::Turn turn(*simulation_);
  parts_ = std::make_unique<Parts>(config, hardware, firmware,
                                   [&] { return std::make_unique<TopModule>("hardware", model); });
}
System::~System() {
  const Simulation::Turn turn(*simulation_);
  parts_.reset();
}

std::vector<JobReport> System::run(std::span<const Job> jobs) {
  const Simulation::Turn turn(*simulation_);
  Parts& parts = *parts_;
  if (jobs.size() > 1U << Parts::kJobLog2) throw std::length_error("more jobs than the table has places");
  if (jobs.empty()) return {};
  const std::uint32_t first = parts.posted;
  parts.next_words = parts.first_words();
  parts.taken_before = parts.taken.size();
  for (const Job& job : jobs) parts.post(job);
  parts.mailbox.ring();
  parts.simulate();
  const auto fail = [&](const char* what) {
    throw std::runtime_error(std::string(what) + "; its log:\n" + parts.log);
  };
  if (parts.failed()) fail("the firmware has given up");
  if (!parts.finished()) fail("the firmware has reached the limit of cycles");
  std::vector<JobReport> reports;
  for (std::uint32_t number = first; number != parts.posted; ++number)
    reports.push_back(parts.report(number));
  return reports;
}

JobReport System::results_so_far() {
  const Simulation::Turn turn(*simulation_);
  Parts& parts = *parts_;
  parts.take_results(parts.written);
  const auto from = static_cast<std::ptrdiff_t>(parts.taken_before);
  JobReport report;
  report.results.assign(parts.taken.begin() + from, parts.taken.end());
  report.result_cycles.assign(parts.taken_cycles.begin() + from, parts.taken_cycles.end());
  // Writes under way have a time, but it has not come.
  const auto there = std::ranges::upper_bound(report.result_cycles, to_cycles(sc_core::sc_time_stamp()));
  report.result_cycles.erase(there, report.result_cycles.end());
  report.results.resize(report.result_cycles.size());
  return report;
}

std::uint32_t System::read_register(std::uint32_t offset) {
  const Simulation::Turn turn(*simulation_);
  return parts_->access(tlm::TLM_READ_COMMAND, offset, 0);
}

void System::write_register(std::uint32_t offset, std::uint32_t value) {
  const Simulation::Turn turn(*simulation_);
  parts_->access(tlm::TLM_WRITE_COMMAND, offset, value);
}

void System::set_fault_injector(FaultInjector injector) {
  parts_->injector = std::move(injector);
}

void System::set_event_log(std::function<void(const std::string& line)> sink) {
  Parts& parts = *parts_;
  parts.event_sink = std::move(sink);
  if (!parts.event_sink) {
    parts.router.observe = nullptr;
    parts.hardware->observe = nullptr;
    return;
  }
  parts.router.observe = [&parts](const TransactionEvent& event) { parts.event_sink(to_json(event)); };
  parts.hardware->observe = [&parts](const DescriptorEvent& event) { parts.event_sink(to_json(event)); };
}

const std::string& System::log() const {
  return parts_->log;
}

SystemStatistics System::statistics() const {
  const Simulation::Turn turn(*simulation_);
  const Parts& parts = *parts_;
  SystemStatistics result;
  result.cycles = to_cycles(sc_core::sc_time_stamp());
  result.cpu = parts.cpu.counters();
  result.register_reads = parts.cpu.traffic().register_reads;
  result.register_writes = parts.cpu.traffic().register_writes;
  result.cycles_polling = parts.cpu.traffic().cycles_polling;
  result.dram = parts.dram.statistics();
  for (const BusStatistics& bus : parts.router.statistics())
    result.bus.push_back({bus.target, bus.reads, bus.writes, bus.bytes});
  return result;
}

}  // namespace gnomon::sim::system

/// libsystemc asks for it; this program has a main of its own.
int sc_main(int, char**) {
  return 0;
}
