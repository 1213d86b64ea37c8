// SPDX-License-Identifier: Apache-2.0
// Modules wired together; a host in zero time.
#include "sim/system/system_top.hpp"

#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "firmware/driver/job_runner.h"
#include "sim/registers/registers.hpp"
#include "sim/system/event_log.hpp"
#include "sim/system/modules/clock.hpp"
#include "sim/system/modules/cpu_module.hpp"
#include "sim/system/modules/dram_module.hpp"
#include "sim/system/modules/hardware_module.hpp"
#include "sim/system/modules/line_watch.hpp"
#include "sim/system/modules/peripherals.hpp"
#include "sim/system/modules/router.hpp"

namespace gnomon::sim::system {

namespace mb = registers::mailbox;

namespace {

constexpr std::uint32_t kDram = 0x80000000, kBlock = 4096;
// The host's layout of the DRAM; commands follow the result ring, which is aligned to its 8 MiB at most.
constexpr std::uint32_t kCommandRing = kDram + 0x1000, kCommandLog2 = 4;
constexpr std::uint32_t kJobTable = kDram + 0x10000, kJobLog2 = 8;
constexpr std::uint32_t kPlanes = kDram + 0x100000, kResultRing = kDram + 0x800000;
constexpr std::uint64_t kLeastDram = 32U << 20U, kMostDram = std::uint64_t{2} << 30U;
constexpr std::uint32_t kLeastRing = 6, kMostRing = 20;

/// A simulation of its own: SystemC cannot elaborate again once it has run.
class Simulation {
 public:
  Simulation() : context_(std::make_unique<sc_core::sc_simcontext>()) { use(context_.get()); }
  ~Simulation() { use(nullptr); }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

 private:
  static void use(sc_core::sc_simcontext* context) {
    sc_core::sc_curr_simcontext = context;
    sc_core::sc_default_global_context = context;
  }
  std::unique_ptr<sc_core::sc_simcontext> context_;
};

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

const SystemConfig& checked(const SystemConfig& config) {
  if (config.dram_bytes < kLeastDram || config.dram_bytes > kMostDram)
    throw std::invalid_argument("DRAM of less than 32 MiB or more than 2 GiB");
  if (config.result_ring_log2 < kLeastRing || config.result_ring_log2 > kMostRing)
    throw std::invalid_argument("a result ring of less than 2^6 or more than 2^20 words");
  if (config.quantum == 0) throw std::invalid_argument("a quantum of 0 cycles");
  return config;
}

}  // namespace

struct System::Parts {
  Parts(const SystemConfig& system_config, golden::Engine& engine, std::span<const std::uint8_t> firmware,
        EngineClock clock);

  void wire();
  void log_line(const char* line, bool level) const;
  void set_up_mailbox();
  void on_firmware_write(std::uint32_t offset, std::uint32_t value);
  void take_results();
  std::uint32_t place(std::span<const golden::Word> words);
  void post(const Job& job);
  JobReport report(std::uint32_t number);
  std::uint8_t* memory(std::uint64_t address) { return dram.storage().data() + (address - kDram); }
  std::uint32_t first_words() const { return kResultRing + (8U << config.result_ring_log2); }

  SystemConfig config;
  Simulation simulation;  // before all modules, and gone after them
  CpuModule cpu;
  Router router;
  DramModule dram;
  HardwareModule hardware;
  MailboxModule mailbox;
  TimerModule timer;
  sc_core::sc_signal<bool> external, software, timer_line;
  LineWatch watch_external, watch_software, watch_timer;
  std::function<void(const std::string&)> event_sink;

  FaultInjector injector;
  std::string log;
  std::vector<golden::Word> taken;  // all results so far
  std::uint64_t next_words = 0;     // where the next stream goes
  std::uint32_t posted = 0;
};

System::Parts::Parts(const SystemConfig& system_config, golden::Engine& engine,
                     std::span<const std::uint8_t> firmware, EngineClock clock)
    : config(checked(system_config)),
      cpu("cpu", firmware, config.quantum),
      router("router", config.bus_latency),
      dram("dram", config.dram_bytes, config.dram),
      hardware("hardware", engine, std::move(clock)),
      mailbox("mailbox"),
      timer("timer"),
      external("external"),
      software("software"),
      timer_line("timer_line"),
      watch_external("watch_external", [this](bool level) { log_line("external", level); }),
      watch_software("watch_software", [this](bool level) { log_line("software", level); }),
      watch_timer("watch_timer", [this](bool level) { log_line("timer", level); }) {
  wire();
  set_up_mailbox();
  next_words = first_words();
}

void System::Parts::wire() {
  cpu.socket.bind(router.targets);
  hardware.memory_socket.bind(router.targets);
  const auto connect = [&](auto& socket, const char* name, std::uint64_t base, std::uint64_t bytes) {
    router.initiators.bind(socket);
    router.map(name, base, bytes);
  };
  connect(dram.socket, "dram", kDram, config.dram_bytes);
  connect(hardware.registers_socket, "hardware", registers::hardware::kBase, kBlock);
  connect(mailbox.socket, "mailbox", mb::kBase, kBlock);
  connect(timer.socket, "timer", registers::timer::kBase, kBlock);
  cpu.external(external);
  cpu.software(software);
  cpu.timer(timer_line);
  hardware.interrupt(external);
  mailbox.doorbell(software);
  timer.expired(timer_line);
  watch_external.line(external);
  watch_software.line(software);
  watch_timer.line(timer_line);
  mailbox.on_write = [this](std::uint32_t offset, std::uint32_t value) { on_firmware_write(offset, value); };
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
  mailbox.set(mb::kPlanesOffset, kPlanes);
}

void System::Parts::on_firmware_write(std::uint32_t offset, std::uint32_t value) {
  if (offset == mb::kLogOffset) log += static_cast<char>(value);
  if (offset == mb::kResultsReadyOffset) take_results();
  const bool finished = offset == mb::kJobsFinishedOffset && value == posted;
  const bool failed = offset == mb::kStateOffset && value == mb::kStateIsFailed;
  if (finished || failed) sc_core::sc_pause();
}

void System::Parts::take_results() {
  const std::uint32_t ready = mailbox.get(mb::kResultsReadyOffset);
  const auto before = static_cast<std::uint32_t>(taken.size());
  for (std::uint32_t i = before; i != ready; ++i) {
    const std::uint32_t place = i & ((1U << config.result_ring_log2) - 1U);
    golden::Word word = 0;
    std::memcpy(&word, memory(kResultRing + std::uint64_t{place} * sizeof word), sizeof word);
    taken.push_back(word);
  }
  if (ready == before) return;
  mailbox.set(mb::kResultsTakenOffset, ready);
  mailbox.ring();
}

std::uint32_t System::Parts::place(std::span<const golden::Word> words) {
  if (next_words + words.size_bytes() > kDram + config.dram_bytes)
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
          {taken.begin() + record.results_begin, taken.begin() + record.results_end}};
}

System::System(const SystemConfig& config, golden::Engine& engine, std::span<const std::uint8_t> firmware,
               EngineClock clock)
    : parts_(std::make_unique<Parts>(config, engine, firmware, std::move(clock))) {}
System::~System() = default;

std::vector<JobReport> System::run(std::span<const Job> jobs) {
  Parts& parts = *parts_;
  if (jobs.size() > 1U << kJobLog2) throw std::length_error("more jobs than the table has places");
  if (jobs.empty()) return {};
  const std::uint32_t first = parts.posted;
  parts.next_words = parts.first_words();
  for (const Job& job : jobs) parts.post(job);
  parts.mailbox.ring();
  sc_core::sc_start(cycles(parts.config.cycle_limit));
  const auto fail = [&](const char* what) {
    throw std::runtime_error(std::string(what) + "; its log:\n" + parts.log);
  };
  if (parts.mailbox.get(mb::kStateOffset) == mb::kStateIsFailed) fail("the firmware has given up");
  if (parts.mailbox.get(mb::kJobsFinishedOffset) != parts.posted)
    fail("the firmware has reached the limit of cycles");
  std::vector<JobReport> reports;
  for (std::uint32_t number = first; number != parts.posted; ++number)
    reports.push_back(parts.report(number));
  return reports;
}

void System::set_fault_injector(FaultInjector injector) {
  parts_->injector = std::move(injector);
}

void System::set_event_log(std::function<void(const std::string& line)> sink) {
  Parts& parts = *parts_;
  parts.event_sink = std::move(sink);
  if (!parts.event_sink) {
    parts.router.observe = nullptr;
    parts.hardware.observe = nullptr;
    return;
  }
  parts.router.observe = [&parts](const TransactionEvent& event) { parts.event_sink(to_json(event)); };
  parts.hardware.observe = [&parts](const DescriptorEvent& event) { parts.event_sink(to_json(event)); };
}

const std::string& System::log() const {
  return parts_->log;
}

SystemStatistics System::statistics() const {
  const Parts& parts = *parts_;
  SystemStatistics result;
  result.cycles = to_cycles(sc_core::sc_time_stamp());
  result.cpu = parts.cpu.counters();
  result.register_reads = parts.cpu.traffic().register_reads;
  result.register_writes = parts.cpu.traffic().register_writes;
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
