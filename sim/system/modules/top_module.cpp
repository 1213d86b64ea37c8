// SPDX-License-Identifier: Apache-2.0
// The model runs ahead of the simulation by a few cycles at most; what it asks memory for meanwhile is
// answered at its own time.
#include "sim/system/modules/top_module.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "sim/rtl_engine.hpp"
#include "sim/system/modules/clock.hpp"
#include "sim/system/modules/register_target.hpp"

namespace gnomon::sim::system {
namespace {

constexpr std::uint64_t kAhead = 64;           // cycles, also of what others see of it
constexpr std::uint64_t kAccessCycles = 4096;  // of a register, beyond which it does not answer
constexpr int kOkay = 0, kSlaveError = 2, kDecodeError = 3;
constexpr std::uint32_t kUserMask = 15, kDescriptors = 1,
                        kCommands = 2;  // ids (docs/system.md, "The master")

}  // namespace

TopModule::TopModule(const sc_core::sc_module_name& name, TopModel& model)
    : HardwareBase(name), registers_("registers"), memory_("memory"), model_(model) {
  registers_.register_b_transport(this, &TopModule::transport);
  SC_HAS_PROCESS(TopModule);
  SC_THREAD(work);
  SC_METHOD(drive);
  sensitive << changed_;
}

void TopModule::work() {
  try {
    for (;;) {
      const std::uint64_t now = to_cycles(sc_core::sc_time_stamp());
      if (model_.cycle() <= now) advance(now + kAhead);
      wait(cycles(model_.cycle() - now));
      changed_.notify(sc_core::SC_ZERO_TIME);
    }
  } catch (const sc_core::sc_unwind_exception&) {  // SystemC's own
    throw;
  } catch (const std::exception&) {
    fail();
  }
}

/// Stops at a change of the interrupt line, so that it is seen at its time.
void TopModule::advance(std::uint64_t until) {
  while (model_.cycle() < until) {
    const int events = model_.run(until);
    serve();
    if ((events & GNOMON_TOP_INTERRUPT) != 0) return;
  }
}

void TopModule::serve() {
  GnomonTopRead read{};
  while (model_.take(read)) serve(read);
  GnomonTopWrite write{};
  while (model_.take(write)) serve(write);
}

TopModule::Answer TopModule::transfer(tlm::tlm_command command, std::uint64_t cycle, std::uint64_t address,
                                      std::span<std::uint8_t> data) {
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(address);
  payload.set_data_ptr(data.data());
  payload.set_data_length(static_cast<unsigned>(data.size()));
  payload.set_streaming_width(static_cast<unsigned>(data.size()));
  const std::uint64_t now = to_cycles(sc_core::sc_time_stamp());
  sc_core::sc_time delay = cycles(std::max(cycle, now) - now);
  memory_->b_transport(payload, delay);
  const std::uint64_t end = std::max(now + to_cycles(delay), cycle + 1);
  switch (payload.get_response_status()) {
    case tlm::TLM_OK_RESPONSE:
      return {end, kOkay};
    case tlm::TLM_INCOMPLETE_RESPONSE:
      return {end, std::nullopt};
    case tlm::TLM_ADDRESS_ERROR_RESPONSE:
      return {end, kDecodeError};
    default:
      return {end, kSlaveError};
  }
}

/// Beats pass as memory gives them: the last of them at the end.
void TopModule::serve(const GnomonTopRead& read) {
  std::array<std::uint8_t, GNOMON_TOP_BURST_BYTES> data{};
  const std::span<std::uint8_t> bytes = std::span(data).first(read.bytes);
  const Answer answer = transfer(tlm::TLM_READ_COMMAND, read.cycle, read.address, bytes);
  if (!answer.response) return;
  if ((read.id & kUserMask) == kCommands) words_taken_ += read.bytes / sizeof(std::uint64_t);
  if ((read.id & kUserMask) == kDescriptors && observe) tell_descriptor(read, bytes);
  const std::uint64_t first = answer.cycle - std::min<std::uint64_t>(answer.cycle, read.beats - 1);
  model_.answer(read, std::max(first, read.cycle + 1), bytes, *answer.response);
}

void TopModule::tell_descriptor(const GnomonTopRead& read, std::span<const std::uint8_t> data) const {
  std::array<std::uint64_t, 2> words{};
  const std::size_t offset = read.start - read.address;
  if (offset + sizeof words > data.size()) return;
  std::memcpy(words.data(), data.data() + offset, sizeof words);
  observe({.cycle = read.cycle,
           .job = static_cast<std::uint16_t>(words[1] >> 32U),
           .words = static_cast<std::uint32_t>(words[1]),
           .flags = static_cast<std::uint16_t>(words[1] >> 48U),
           .address = words[0]});
}

/// A transaction for each run of bytes that is to be written; most have one.
void TopModule::serve(const GnomonTopWrite& write) {
  Answer answer{write.cycle + 1, kOkay};
  for (std::uint64_t left = write.strobe; left != 0;) {
    const int first = std::countr_zero(left);
    const int count = std::countr_one(left >> first);
    std::array<std::uint8_t, GNOMON_TOP_LINE_BYTES> data{};
    std::memcpy(data.data(), write.data + first, static_cast<std::size_t>(count));
    answer = transfer(tlm::TLM_WRITE_COMMAND, write.cycle, write.address + static_cast<std::uint64_t>(first),
                      std::span(data).first(static_cast<std::size_t>(count)));
    if (answer.response != kOkay || first + count == 64) break;
    left &= ~std::uint64_t{0} << (first + count);
  }
  if (answer.response) model_.answer(write, answer.cycle, *answer.response);
}

std::optional<std::uint32_t> TopModule::end_access() {
  const std::uint64_t begin = model_.cycle();
  for (;;) {
    const int events = model_.run(begin + kAccessCycles);
    serve();
    if ((events & GNOMON_TOP_INTERRUPT) != 0) changed_.notify(sc_core::SC_ZERO_TIME);
    if ((events & GNOMON_TOP_ACCESS) != 0) break;
    if (events == 0)
      throw RtlFault("a register has not answered for " + std::to_string(kAccessCycles) + " cycles");
  }
  std::uint32_t data = 0;
  if (!model_.end_access(data)) return std::nullopt;
  return data;
}

void TopModule::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  const std::uint64_t begin = model_.cycle();
  try {
    transport_register(
        payload,
        [&](std::uint32_t offset) {
          model_.begin_read(offset);
          return end_access();
        },
        [&](std::uint32_t offset, std::uint32_t value) {
          model_.begin_write(offset, value);
          return end_access().has_value();
        });
  } catch (const std::exception&) {
    payload.set_response_status(tlm::TLM_GENERIC_ERROR_RESPONSE);
    fail();
  }
  delay += cycles(model_.cycle() - begin);
}

}  // namespace gnomon::sim::system
