// SPDX-License-Identifier: Apache-2.0
// Registers with a line each.
#include "sim/system/modules/peripherals.hpp"

#include "sim/registers/registers.hpp"
#include "sim/system/modules/clock.hpp"
#include "sim/system/modules/register_target.hpp"

namespace gnomon::sim::system {

namespace mb = registers::mailbox;
namespace tm = registers::timer;

MailboxModule::MailboxModule(const sc_core::sc_module_name& name)
    : sc_module(name), socket("socket"), doorbell("doorbell"), file_(mb::kRegisters) {
  socket.register_b_transport(this, &MailboxModule::transport);
  SC_HAS_PROCESS(MailboxModule);
  SC_METHOD(drive);
  sensitive << changed_;
}

void MailboxModule::drive() {
  doorbell.write(file_.get(mb::kDoorbellOffset) != 0);
}

void MailboxModule::ring() {
  file_.set(mb::kDoorbellOffset, mb::kDoorbellRungMask);
  changed_.notify(sc_core::SC_ZERO_TIME);
}

bool MailboxModule::write(std::uint32_t offset, std::uint32_t value) {
  if (!file_.write(offset, value)) return false;
  changed_.notify(sc_core::SC_ZERO_TIME);
  if (on_write) on_write(offset, value);
  return true;
}

void MailboxModule::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
  transport_register(
      payload, [&](std::uint32_t offset) { return file_.read(offset); },
      [&](std::uint32_t offset, std::uint32_t value) { return write(offset, value); });
}

TimerModule::TimerModule(const sc_core::sc_module_name& name)
    : sc_module(name), socket("socket"), expired("expired"), file_(tm::kRegisters) {
  socket.register_b_transport(this, &TimerModule::transport);
  SC_HAS_PROCESS(TimerModule);
  SC_METHOD(drive);
  sensitive << changed_;
}

/// Comes back when the comparand will be reached.
void TimerModule::drive() {
  const std::uint64_t now = to_cycles(sc_core::sc_time_stamp());
  const std::uint64_t compare =
      file_.get(tm::kCompareLowOffset) | std::uint64_t{file_.get(tm::kCompareHighOffset)} << 32U;
  expired.write(now >= compare);
  const std::uint64_t left = compare - now;
  // Beyond what time can hold it means never.
  if (now < compare && left < std::uint64_t{1} << 48U) changed_.notify(cycles(left));
}

std::optional<std::uint32_t> TimerModule::read(std::uint32_t offset) {
  const std::uint64_t now = to_cycles(sc_core::sc_time_stamp());
  file_.set(tm::kTimeLowOffset, static_cast<std::uint32_t>(now));
  file_.set(tm::kTimeHighOffset, static_cast<std::uint32_t>(now >> 32U));
  return file_.read(offset);
}

bool TimerModule::write(std::uint32_t offset, std::uint32_t value) {
  if (!file_.write(offset, value)) return false;
  changed_.cancel();
  changed_.notify(sc_core::SC_ZERO_TIME);
  return true;
}

void TimerModule::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
  transport_register(
      payload, [&](std::uint32_t offset) { return read(offset); },
      [&](std::uint32_t offset, std::uint32_t value) { return write(offset, value); });
}

}  // namespace gnomon::sim::system
