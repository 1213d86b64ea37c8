// SPDX-License-Identifier: Apache-2.0
// Modules wired together; the host's layout of the DRAM.
#include "sim/system/system_parts.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "firmware/driver/job_runner.h"
#include "sim/system/event_log.hpp"
#include "sim/system/modules/clock.hpp"

namespace gnomon::sim::system {

namespace mb = registers::mailbox;

namespace {

constexpr std::uint32_t kDram = 0x80000000, kBlock = 4096;
// The host's layout of the DRAM; commands follow the result ring, which is aligned to its 8 MiB at most.
constexpr std::uint32_t kCommandRing = kDram + 0x1000, kCommandLog2 = 4;
constexpr std::uint32_t kJobTable = kDram + 0x10000;
constexpr std::uint32_t kResultRing = kDram + 0x800000;
constexpr std::uint64_t kLeastDram = 32U << 20U, kMostDram = std::uint64_t{2} << 30U;
constexpr std::uint32_t kLeastRing = 6, kMostRing = 20;
constexpr std::uint64_t kSlice = 1U << 14U;  // cycles between two looks at what ends a run

std::optional<tlm::tlm_response_status> response(Fault fault) {
  switch (fault) {
    case Fault::None:
      return std::nullopt;
    case Fault::SlaveError:
      return tlm::TLM_GENERIC_ERROR_RESPONSE;
    case Fault::DecodeError:
      return tlm::TLM_ADDRESS_ERROR_RESPONSE;
    case Fault::NoAnswer:
      return tlm::TLM_INCOMPLETE_RESPONSE;
  }
  return std::nullopt;
}

constexpr std::uint64_t in_blocks(std::uint64_t bytes) {
  return (bytes + kBlock - 1) / kBlock * kBlock;
}

/// What memories of this build take at most behind a cache (docs/cache.md, "One cache for each memory").
std::uint64_t bytes_of_planes(const golden::HardwareConfig& build) {
  const std::uint64_t entries = std::uint64_t{1} << (2 * build.plane_log2);
  const std::uint64_t pixels = std::uint64_t{1} << (2 * build.slb_plane_log2);
  std::uint64_t bytes = in_blocks(4 * entries);  // the plane, whatever else is built
  if (build.en_slb) bytes += in_blocks(4 * pixels) + in_blocks(64 * pixels);
  if (build.en_vpu_topology)
    bytes += in_blocks(8 * entries) + in_blocks(std::uint64_t{16} << build.nodes_log2) +
             in_blocks(std::uint64_t{32} << build.quads_log2);
  return bytes;
}

const SystemConfig& checked(const SystemConfig& config) {
  if (config.dram_bytes < kLeastDram || config.dram_bytes > kMostDram)
    throw std::invalid_argument("DRAM of less than 32 MiB or more than 2 GiB");
  if (config.result_ring_log2 < kLeastRing || config.result_ring_log2 > kMostRing)
    throw std::invalid_argument("a result ring of less than 2^6 or more than 2^20 words");
  if (config.quantum == 0) throw std::invalid_argument("a quantum of 0 cycles");
  return config;
}

}  // namespace

std::uint8_t* System::Parts::memory(std::uint64_t address) {
  return dram.storage().data() + (address - kDram);
}

std::uint32_t System::Parts::first_words() const {
  return kResultRing + (8U << config.result_ring_log2);
}

System::Parts::Parts(const SystemConfig& system_config, const golden::HardwareConfig& build,
                     std::span<const std::uint8_t> firmware, const MakeHardware& make_hardware)
    : config(checked(system_config)),
      cpu("cpu", firmware, config.quantum),
      router("router", config.bus_latency),
      dram("dram", config.dram_bytes, config.dram),
      hardware(make_hardware()),
      mailbox("mailbox"),
      timer("timer"),
      external("external"),
      software("software"),
      timer_line("timer_line"),
      watch_external("watch_external", [this](bool level) { log_line("external", level); }),
      watch_software("watch_software", [this](bool level) { log_line("software", level); }),
      watch_timer("watch_timer", [this](bool level) { log_line("timer", level); }) {
  wire();
  const std::uint64_t planes_bytes = bytes_of_planes(build);
  if (planes_bytes > config.dram_bytes / 2) throw std::invalid_argument("DRAM too small for the planes");
  planes = static_cast<std::uint32_t>(kDram + config.dram_bytes - planes_bytes);
  set_up_mailbox();
  place_cycles.resize(std::size_t{1} << config.result_ring_log2);
  next_words = first_words();
}

void System::Parts::wire() {
  cpu.socket.bind(router.targets);
  hardware->memory_side().bind(router.targets);
  const auto connect = [&](auto& socket, const char* name, std::uint64_t base, std::uint64_t bytes) {
    router.initiators.bind(socket);
    router.map(name, base, bytes);
  };
  connect(dram.socket, "dram", kDram, config.dram_bytes);
  connect(hardware->register_side(), "hardware", registers::hardware::kBase, kBlock);
  connect(mailbox.socket, "mailbox", mb::kBase, kBlock);
  connect(timer.socket, "timer", registers::timer::kBase, kBlock);
  cpu.external(external);
  cpu.software(software);
  cpu.timer(timer_line);
  hardware->interrupt(external);
  mailbox.doorbell(software);
  timer.expired(timer_line);
  watch_external.line(external);
  watch_software.line(software);
  watch_timer.line(timer_line);
  mailbox.on_write = [this](std::uint32_t offset, std::uint32_t value) { on_firmware_write(offset, value); };
  router.on_hardware_write = [this](std::uint64_t address, std::uint32_t bytes, std::uint64_t cycle) {
    on_hardware_write(address, bytes, cycle);
  };
  router.inject = [this](int initiator, const tlm::tlm_generic_payload& payload) {
    if (initiator != Router::kHardware || !injector) return response(Fault::None);
    return response(injector(payload.get_address(), payload.is_write()));
  };
}

void System::Parts::log_line(const char* line, bool level) const {
  if (event_sink) event_sink(to_json(InterruptEvent{to_cycles(sc_core::sc_time_stamp()), line, level}));
}

void System::Parts::set_up_mailbox() {
  mailbox.set(mb::kCommandRingOffset, kCommandRing);
  mailbox.set(mb::kCommandRingLog2Offset, kCommandLog2);
  mailbox.set(mb::kResultRingOffset, kResultRing);
  mailbox.set(mb::kResultRingLog2Offset, config.result_ring_log2);
  mailbox.set(mb::kJobTableOffset, kJobTable);
  mailbox.set(mb::kJobTableLog2Offset, kJobLog2);
  mailbox.set(mb::kPlanesOffset, planes);
}

void System::Parts::on_firmware_write(std::uint32_t offset, std::uint32_t value) {
  if (offset == mb::kLogOffset) log += static_cast<char>(value);
  if (offset == mb::kResultsReadyOffset) hand_over_results();
  if ((offset == mb::kJobsFinishedOffset && finished()) || (offset == mb::kStateOffset && failed()))
    sc_core::sc_pause();
}

/// Places of the result ring are written in order, so that each stands for the next count that fits it.
void System::Parts::on_hardware_write(std::uint64_t address, std::uint32_t bytes, std::uint64_t cycle) {
  const std::uint64_t ring_bytes = place_cycles.size() * sizeof(golden::Word);
  if (address < kResultRing || address - kResultRing >= ring_bytes) return;
  const auto first = static_cast<std::uint32_t>((address - kResultRing) / sizeof(golden::Word));
  const auto words = static_cast<std::uint32_t>(bytes / sizeof(golden::Word));
  for (std::uint32_t i = 0; i < words; ++i) place_cycles.at(first + i) = cycle;
  const auto oldest = static_cast<std::uint32_t>(taken.size());
  written = oldest + ((first - oldest) & (static_cast<std::uint32_t>(place_cycles.size()) - 1U)) + words;
}

void System::Parts::take_results(std::uint32_t ready) {
  for (auto i = static_cast<std::uint32_t>(taken.size()); i != ready; ++i) {
    const std::uint32_t place = i & (static_cast<std::uint32_t>(place_cycles.size()) - 1U);
    golden::Word word = 0;
    std::memcpy(&word, memory(kResultRing + std::uint64_t{place} * sizeof word), sizeof word);
    taken.push_back(word);
    taken_cycles.push_back(place_cycles[place]);
  }
}

void System::Parts::hand_over_results() {
  const std::uint32_t ready = mailbox.get(mb::kResultsReadyOffset);
  if (ready == static_cast<std::uint32_t>(taken.size())) return;
  take_results(ready);
  mailbox.set(mb::kResultsTakenOffset, ready);
  mailbox.ring();
}

std::uint32_t System::Parts::place(std::span<const golden::Word> words) {
  if (next_words + words.size_bytes() > planes)
    throw std::length_error("the command streams do not fit the DRAM");
  const auto address = static_cast<std::uint32_t>(next_words);
  if (!words.empty()) std::memcpy(memory(next_words), words.data(), words.size_bytes());
  next_words += words.size_bytes();
  return address;
}

void System::Parts::post(const Job& job) {
  gnomon_job record{};
  record.address = place(job.commands);
  record.words = static_cast<std::uint32_t>(job.commands.size());
  record.fallback_address = place(job.fallback);
  record.fallback_words = static_cast<std::uint32_t>(job.fallback.size());
  record.fallback_flags = job.fallback_flags;
  record.retries = job.retries;
  record.watchdog = job.watchdog;
  std::memcpy(memory(kJobTable + posted % (1U << kJobLog2) * sizeof record), &record, sizeof record);
  mailbox.set(mb::kJobsPostedOffset, ++posted);
}

JobReport System::Parts::report(std::uint32_t number) {
  gnomon_job record{};
  std::memcpy(&record, memory(kJobTable + number % (1U << kJobLog2) * sizeof record), sizeof record);
  return {record.outcome,
          record.flags,
          record.errors,
          record.attempts,
          record.error,
          record.instructions,
          {taken.begin() + record.results_begin, taken.begin() + record.results_end},
          {taken_cycles.begin() + record.results_begin, taken_cycles.begin() + record.results_end}};
}

/// Past the bus, in no time.
std::uint32_t System::Parts::access(tlm::tlm_command command, std::uint32_t offset, std::uint32_t value) {
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(offset);
  payload.set_data_ptr(reinterpret_cast<unsigned char*>(&value));
  payload.set_data_length(sizeof value);
  payload.set_streaming_width(sizeof value);
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  hardware->register_side().get_base_export()->b_transport(payload, delay);
  if (hardware->fault()) std::rethrow_exception(hardware->fault());
  if (!payload.is_response_ok()) throw std::logic_error("no register at offset " + std::to_string(offset));
  return value;
}

void System::Parts::check_limits(std::uint64_t now) const {
  if (config.abort != nullptr && config.abort->load(std::memory_order_relaxed))
    throw Aborted("interrupted at cycle " + std::to_string(now));
  if (now >= config.max_cycles) throw CycleLimit("stopped after " + std::to_string(now) + " cycles");
}

/// Until the jobs are finished, the firmware has failed, or the limit of a run is reached.
void System::Parts::simulate() {
  std::uint64_t now = to_cycles(sc_core::sc_time_stamp());
  const std::uint64_t end = now + config.cycle_limit;
  check_limits(now);
  for (;;) {
    sc_core::sc_start(cycles(std::min({kSlice, end - now, config.max_cycles - now})));
    if (hardware->fault()) std::rethrow_exception(hardware->fault());
    now = to_cycles(sc_core::sc_time_stamp());
    if (failed() || finished() || now >= end) return;
    check_limits(now);
    if (config.progress)
      config.progress({.cycles = now, .words = hardware->words_taken(), .results = written});
  }
}

}  // namespace gnomon::sim::system
