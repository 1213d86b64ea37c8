// SPDX-License-Identifier: Apache-2.0
// The modules of the system, and a host in zero time.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/registers/registers.hpp"
#include "sim/system/modules/cpu_module.hpp"
#include "sim/system/modules/dram_module.hpp"
#include "sim/system/modules/hardware_base.hpp"
#include "sim/system/modules/line_watch.hpp"
#include "sim/system/modules/peripherals.hpp"
#include "sim/system/modules/router.hpp"
#include "sim/system/system_top.hpp"

namespace gnomon::sim::system {

struct System::Parts {
  static constexpr std::uint32_t kJobLog2 = 8;  // places of the job table
  using MakeHardware = std::function<std::unique_ptr<HardwareBase>()>;
  Parts(const SystemConfig& system_config, const golden::HardwareConfig& build,
        std::span<const std::uint8_t> firmware, const MakeHardware& make_hardware);

  void wire();
  void log_line(const char* line, bool level) const;
  void set_up_mailbox();
  void on_firmware_write(std::uint32_t offset, std::uint32_t value);
  void on_hardware_write(std::uint64_t address, std::uint32_t bytes, std::uint64_t cycle);
  bool failed() const {
    return mailbox.get(registers::mailbox::kStateOffset) == registers::mailbox::kStateIsFailed;
  }
  bool finished() const { return mailbox.get(registers::mailbox::kJobsFinishedOffset) == posted; }
  void simulate();
  void check_limits(std::uint64_t now) const;
  void take_results(std::uint32_t ready);
  void hand_over_results();
  std::uint32_t place(std::span<const golden::Word> words);
  void post(const Job& job);
  JobReport report(std::uint32_t number);
  std::uint32_t access(tlm::tlm_command command, std::uint32_t offset, std::uint32_t value);
  std::uint8_t* memory(std::uint64_t address);
  std::uint32_t first_words() const;

  SystemConfig config;
  CpuModule cpu;
  Router router;
  DramModule dram;
  std::unique_ptr<HardwareBase> hardware;
  MailboxModule mailbox;
  TimerModule timer;
  sc_core::sc_signal<bool> external, software, timer_line;
  LineWatch watch_external, watch_software, watch_timer;
  std::function<void(const std::string&)> event_sink;

  FaultInjector injector;
  std::string log;
  std::vector<golden::Word> taken;          // all results so far
  std::vector<std::uint64_t> taken_cycles;  // of each of them
  std::vector<std::uint64_t> place_cycles;  // of each place of the result ring, when it was last written
  std::uint32_t written = 0;                // results that lie in memory, modulo 2^32
  std::size_t taken_before = 0;             // the run under way
  std::uint32_t planes = 0;                 // the last part of the DRAM is theirs
  std::uint64_t next_words = 0;             // where the next stream goes
  std::uint32_t posted = 0;
};

}  // namespace gnomon::sim::system
