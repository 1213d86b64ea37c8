// SPDX-License-Identifier: Apache-2.0
// Two ways to run the firmware against the mock system: its driver compiled for the host, and its image on
// the simulated processor.
#pragma once

#include <cstdint>

#include "firmware/driver/gnomon_driver.h"
#include "firmware/driver/job_runner.h"
#include "sim/cpu/rv32_core.hpp"
#include "tests/firmware/host_platform.hpp"
#include "tests/firmware/mock_system.hpp"

namespace gnomon::firmware::test {

/// FAILURE of the mailbox if STATE is FAILED.
std::uint32_t failure(const MockSystem& system);

class HostMachine {
 public:
  /// From the start until nothing is left to do for the processor.
  void start();
  /// Some cycles, and what the firmware does about them.
  void step();

  MockSystem system;

 private:
  std::uint32_t events();
  void handle(std::uint32_t events);

  HostPlatform platform_{system};
  gnomon_device device_{};
  job_runner runner_{};
  bool dead_ = false;
};

class ImageMachine {
 public:
  ImageMachine();
  void start();
  void step();

  MockSystem system;
  sim::cpu::Rv32Core core{system};
};

/// Steps until so many jobs are finished, the host taking results as they come; false if the firmware has
/// failed or does not get there.
template <class Machine>
bool run_jobs(Machine& machine, std::uint32_t jobs) {
  for (int i = 0; i < 20'000 && failure(machine.system) == 0; ++i) {
    machine.step();
    machine.system.take_results();
    if (machine.system.finished() == jobs) return true;
  }
  return false;
}

}  // namespace gnomon::firmware::test
