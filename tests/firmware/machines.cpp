// SPDX-License-Identifier: Apache-2.0
// What the trap handler and the command loop do, for the host; clock and interrupt lines, for the image.
#include "tests/firmware/machines.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/registers/registers.hpp"

namespace gnomon::firmware::test {

namespace mb = sim::registers::mailbox;
using sim::cpu::Interrupt;

namespace {

constexpr std::uint64_t kStep = 100;  // cycles

}  // namespace

std::uint32_t failure(const MockSystem& system) {
  return system.mailbox.get(mb::kStateOffset) == mb::kStateIsFailed ? system.mailbox.get(mb::kFailureOffset)
                                                                    : 0;
}

void HostMachine::handle(std::uint32_t events) {
  const std::uint32_t failure = job_runner_handle(&runner_, events);
  if (failure == mb::kFailureIsNone) return;
  system.mailbox.set(mb::kFailureOffset, failure);
  system.mailbox.set(mb::kStateOffset, mb::kStateIsFailed);
  dead_ = true;
}

void HostMachine::start() {
  gnomon_capabilities capabilities{};
  std::uint32_t failure = mb::kFailureIsNoHardware;
  if (gnomon_probe(&device_, sim::registers::hardware::kBase, &capabilities) == GNOMON_OK)
    failure = job_runner_open(&runner_, &device_);
  if (failure == mb::kFailureIsNone) return handle(0);
  system.mailbox.set(mb::kFailureOffset, failure);
  system.mailbox.set(mb::kStateOffset, mb::kStateIsFailed);
  dead_ = true;
}

std::uint32_t HostMachine::events() {
  const Lines lines = system.lines();
  std::uint32_t events = lines.external ? gnomon_take_interrupts(&device_) : 0;
  if (lines.software) {
    system.mailbox.set(mb::kDoorbellOffset, 0);
    events |= GNOMON_EVENT_DOORBELL;
  }
  if (lines.timer) {
    job_runner_stop_watchdog();
    events |= GNOMON_EVENT_WATCHDOG;
  }
  return events;
}

void HostMachine::step() {
  system.advance(kStep);
  if (dead_) return;
  if (const std::uint32_t happened = events(); happened != 0) handle(happened);
}

ImageMachine::ImageMachine() {
  std::ifstream file(GNOMON_FIRMWARE_IMAGE, std::ios::binary);
  const std::vector<char> image{std::istreambuf_iterator<char>(file), {}};
  if (image.empty() || image.size() > system.program.size()) throw std::runtime_error("no firmware image");
  std::copy(image.begin(), image.end(), system.program.begin());
}

void ImageMachine::start() {
  for (int i = 0; i < 1000 && system.mailbox.get(mb::kStateOffset) == mb::kStateIsBooting; ++i) step();
}

void ImageMachine::step() {
  const std::uint64_t before = core.counters().cycles;
  core.run(kStep / 2);
  const std::uint64_t worked = core.counters().cycles - before;
  if (worked < kStep) core.pass_time(kStep - worked);
  system.advance(core.counters().cycles - before);
  const Lines lines = system.lines();
  core.set_interrupt(Interrupt::External, lines.external);
  core.set_interrupt(Interrupt::Software, lines.software);
  core.set_interrupt(Interrupt::Timer, lines.timer);
}

}  // namespace gnomon::firmware::test
