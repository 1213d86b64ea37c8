// SPDX-License-Identifier: Apache-2.0
// Quanta, sleep, accesses.
#include "sim/system/modules/cpu_module.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "sim/system/modules/clock.hpp"

namespace gnomon::sim::system {
namespace {

constexpr std::uint32_t kRegisters = 0x10000000, kRegistersEnd = 0x20000000;

}  // namespace

CpuModule::CpuModule(const sc_core::sc_module_name& name, std::span<const std::uint8_t> image,
                     std::uint32_t quantum_cycles)
    : sc_module(name),
      socket("socket"),
      external("external"),
      software("software"),
      timer("timer"),
      quantum_(quantum_cycles),
      program_(kProgramBytes),
      core_(*this) {
  if (image.size() > program_.size())
    throw std::invalid_argument("the firmware does not fit the program memory");
  std::copy(image.begin(), image.end(), program_.begin());
  SC_HAS_PROCESS(CpuModule);
  SC_THREAD(run);
}

void CpuModule::run() {
  for (;;) {
    sample_lines();
    const cpu::Stop stop = core_.run(quantum_);  // an instruction takes a cycle at least
    synchronise();
    if (stop == cpu::Stop::Asleep) sleep();
  }
}

void CpuModule::sleep() {
  sample_lines();
  if (core_.run(0) != cpu::Stop::Asleep) return;
  const std::uint64_t begin = to_cycles(sc_core::sc_time_stamp());
  wait(external.value_changed_event() | software.value_changed_event() | timer.value_changed_event());
  const std::uint64_t slept = to_cycles(sc_core::sc_time_stamp()) - begin;
  core_.pass_time(slept);
  synchronised_ += slept;
}

void CpuModule::synchronise() {
  const std::uint64_t cycles_ahead = ahead();
  synchronised_ += cycles_ahead;
  if (cycles_ahead != 0) wait(cycles(cycles_ahead));
}

void CpuModule::sample_lines() {
  core_.set_interrupt(cpu::Interrupt::External, external.read());
  core_.set_interrupt(cpu::Interrupt::Software, software.read());
  core_.set_interrupt(cpu::Interrupt::Timer, timer.read());
}

cpu::Reply CpuModule::read(std::uint32_t address, unsigned bytes, cpu::Access) {
  if (address > program_.size() - bytes) return transfer(tlm::TLM_READ_COMMAND, address, bytes, 0);
  cpu::Reply reply;
  std::memcpy(&reply.data, &program_[address], bytes);
  return reply;
}

cpu::Reply CpuModule::write(std::uint32_t address, unsigned bytes, std::uint32_t data) {
  if (address > program_.size() - bytes) return transfer(tlm::TLM_WRITE_COMMAND, address, bytes, data);
  std::memcpy(&program_[address], &data, bytes);
  return {};
}

/// Registers in order and at their time; memory at the processor's own time.
cpu::Reply CpuModule::transfer(tlm::tlm_command command, std::uint32_t address, unsigned bytes,
                               std::uint32_t data) {
  const bool is_register = address >= kRegisters && address < kRegistersEnd;
  const bool is_write = command == tlm::TLM_WRITE_COMMAND;
  if (is_register)
    ++(is_write ? traffic_.register_writes : traffic_.register_reads);
  else
    ++traffic_.memory_accesses;
  if (is_register) synchronise();
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(address);
  payload.set_data_ptr(reinterpret_cast<unsigned char*>(&data));
  payload.set_data_length(bytes);
  payload.set_streaming_width(bytes);
  const sc_core::sc_time begin = cycles(ahead());
  sc_core::sc_time end = begin;
  socket->b_transport(payload, end);
  if (is_register) {
    wait(sc_core::SC_ZERO_TIME);  // lines follow a delta later
    wait(sc_core::SC_ZERO_TIME);
    sample_lines();
    note_polling(command, address, data);
  }
  return {data, static_cast<std::uint32_t>(to_cycles(end - begin)), !payload.is_response_ok()};
}

void CpuModule::note_polling(tlm::tlm_command command, std::uint32_t address, std::uint32_t data) {
  const std::uint64_t awake = core_.counters().cycles - core_.counters().cycles_asleep;
  if (command != tlm::TLM_READ_COMMAND) {
    last_read_.reset();
    return;
  }
  if (last_read_ && last_read_->address == address && last_read_->data == data)
    traffic_.cycles_polling += awake - last_read_->awake;
  last_read_ = {address, data, awake};
}

}  // namespace gnomon::sim::system
