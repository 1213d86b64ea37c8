// SPDX-License-Identifier: Apache-2.0
// The whole system, and the host's side of it (docs/system-model.md).
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/cpu/iss.hpp"
#include "sim/system/dram_timing.hpp"

namespace gnomon::sim::system {

struct SystemConfig {
  std::uint64_t dram_bytes = std::uint64_t{256} << 20U;  ///< 32 MiB..2 GiB
  DramConfig dram;
  std::uint32_t bus_latency = 2;            ///< cycles of a transaction, besides the target's
  std::uint32_t quantum = 1000;             ///< cycles that the processor may be ahead
  std::uint32_t result_ring_log2 = 16;      ///< words, 6..20
  std::uint64_t cycle_limit = 1ULL << 36U;  ///< of a run; beyond it run() throws
};

/// A job, as the host thinks of it; docs/firmware.md.
struct Job {
  std::vector<golden::Word> commands{}, fallback{};
  std::uint32_t fallback_flags = 0, retries = 0, watchdog = 0;
};

struct JobReport {
  std::uint32_t outcome = 0, flags = 0, errors = 0, attempts = 0, error = 0, instructions = 0;
  std::vector<golden::Word> results;
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
  DramStatistics dram;
  std::vector<BusCount> bus;
};

/// SystemC has one simulation at a time: a process has one System at a time.
class System {
 public:
  /// `engine` answers the commands and must outlive the system. `clock` gives the cycles that it has worked
  /// since its reset; without, it takes a command word a cycle. Throws std::invalid_argument for a
  /// configuration or an image that does not fit.
  System(const SystemConfig& config, golden::Engine& engine, std::span<const std::uint8_t> firmware,
         EngineClock clock = {});
  ~System();
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  /// Runs the jobs, in order. Throws std::runtime_error with the firmware's log if it fails or the limit is
  /// reached, and std::length_error if they do not fit the DRAM or the job table.
  std::vector<JobReport> run(std::span<const Job> jobs);

  void set_fault_injector(FaultInjector injector);
  /// Gets every transaction, interrupt and descriptor as a line of JSON, as they are simulated: the processor
  /// may be up to a quantum ahead. Nothing: off.
  void set_event_log(std::function<void(const std::string& line)> sink);
  const std::string& log() const;
  SystemStatistics statistics() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace gnomon::sim::system
