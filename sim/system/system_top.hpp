// SPDX-License-Identifier: Apache-2.0
// The whole system, and the host's side of it (docs/system-model.md).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/cpu/iss.hpp"
#include "sim/rtl_engine.hpp"
#include "sim/system/dram_timing.hpp"
#include "sim/top_model.hpp"

namespace gnomon::sim::system {

class Simulation;

struct SystemConfig {
  std::uint64_t dram_bytes = std::uint64_t{256} << 20U;  ///< 32 MiB..2 GiB
  DramConfig dram;
  std::uint32_t bus_latency = 2;            ///< cycles of a transaction, besides the target's
  std::uint32_t quantum = 1000;             ///< cycles that the processor may be ahead
  std::uint32_t result_ring_log2 = 16;      ///< words, 6..20
  std::uint64_t cycle_limit = 1ULL << 36U;  ///< of a run; beyond it the firmware is taken to hang

  // These three are as in RtlOptions, in cycles since power-up.
  std::uint64_t max_cycles = UINT64_MAX;
  std::function<void(const Progress&)> progress;
  const std::atomic<bool>* abort = nullptr;
};

/// A job, as the host thinks of it; docs/firmware.md.
struct Job {
  std::vector<golden::Word> commands{}, fallback{};
  std::uint32_t fallback_flags = 0, retries = 0, watchdog = 0;
};

struct JobReport {
  std::uint32_t outcome = 0, flags = 0, errors = 0, attempts = 0, error = 0, instructions = 0;
  std::vector<golden::Word> results;
  std::vector<std::uint64_t> result_cycles;  ///< since power-up, at which each of them lay in memory
};

using EngineClock = std::function<std::uint64_t()>;

/// What the router does to a transaction of the hardware's.
enum class Fault : std::uint8_t { None, SlaveError, DecodeError, NoAnswer };
using FaultInjector = std::function<Fault(std::uint64_t address, bool write)>;

struct BusCount {
  std::string target;
  std::uint64_t reads = 0, writes = 0, bytes = 0;
};

struct SystemStatistics {
  std::uint64_t cycles = 0;  ///< since power-up
  cpu::Counters cpu;
  std::uint64_t register_reads = 0, register_writes = 0;  ///< of the processor
  std::uint64_t cycles_polling = 0;                       ///< of it: asking a register again for nothing
  DramStatistics dram;
  std::vector<BusCount> bus;
};

/// A process may have several; those of different threads wait for each other.
class System {
 public:
  /// `engine` answers the commands and must outlive the system. `clock` gives the cycles that it has worked
  /// since its reset; without, it takes a command word a cycle. Throws std::invalid_argument for a
  /// configuration or an image that does not fit.
  System(const SystemConfig& config, golden::Engine& engine, std::span<const std::uint8_t> firmware,
         EngineClock clock = {});
  /// The same around `model`, which must be in reset state and have the hardware `hardware`.
  System(const SystemConfig& config, TopModel& model, const golden::HardwareConfig& hardware,
         std::span<const std::uint8_t> firmware);
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// Runs the jobs, in order. Throws std::runtime_error with the firmware's log if it fails or the limit is
  /// reached, std::length_error if they do not fit the DRAM or the job table, CycleLimit and Aborted as the
  /// configuration says, and what the engine throws. After an exception time does not go on.
  std::vector<JobReport> run(std::span<const Job> jobs);
  /// Results of the last run() that lie in memory: of one that has thrown, those so far, in `results` and
  /// `result_cycles` alone.
  JobReport results_so_far();

  /// A register of the hardware, read by nobody in the system: its clock alone goes on meanwhile. Throws
  /// std::logic_error for an offset without one.
  std::uint32_t read_register(std::uint32_t offset);
  void write_register(std::uint32_t offset, std::uint32_t value);

  void set_fault_injector(FaultInjector injector);
  /// Gets every transaction, interrupt and descriptor as a line of JSON, as they are simulated: the processor
  /// may be up to a quantum ahead. Nothing: off.
  void set_event_log(std::function<void(const std::string& line)> sink);
  const std::string& log() const;
  SystemStatistics statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Simulation> simulation_;  // before all modules, and gone after them
  std::unique_ptr<Parts> parts_;
};

}  // namespace gnomon::sim::system
