// SPDX-License-Identifier: Apache-2.0
// One process: descriptor, commands, results, completion.
#include "sim/system/modules/hardware_module.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/stream.hpp>
#include <utility>

#include "sim/registers/registers.hpp"
#include "sim/system/modules/clock.hpp"
#include "sim/system/modules/register_target.hpp"

namespace gnomon::sim::system {

namespace hw = registers::hardware;
using golden::Word;

namespace {

constexpr std::uint32_t kLine = 64, kLineWords = kLine / sizeof(Word);
constexpr std::uint32_t kOutstanding = 4;
constexpr std::uint32_t kResetTimeout = 65536;
constexpr std::uint16_t kNoJob = 0xFFFF;
constexpr std::uint16_t kLast = 1, kInterrupt = 2, kComplete = 0x8000;
constexpr std::uint32_t kDescriptorBytes = 16;

std::span<std::uint8_t> bytes_of(std::span<Word> values) {
  return {reinterpret_cast<std::uint8_t*>(values.data()), values.size_bytes()};
}

}  // namespace

HardwareModule::HardwareModule(const sc_core::sc_module_name& name, golden::Engine& engine,
                               std::function<std::uint64_t()> clock)
    : HardwareBase(name),
      registers_socket_("registers_socket"),
      memory_socket_("memory_socket"),
      engine_(engine),
      clock_(std::move(clock)),
      registers_(engine.config()) {
  registers_socket_.register_b_transport(this, &HardwareModule::transport);
  SC_HAS_PROCESS(HardwareModule);
  SC_THREAD(work);
  SC_METHOD(drive);
  sensitive << changed_;
}

void HardwareModule::transport(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
  transport_register(
      payload, [&](std::uint32_t offset) { return registers_.read(offset); },
      [&](std::uint32_t offset, std::uint32_t value) { return write(offset, value); });
}

bool HardwareModule::write(std::uint32_t offset, std::uint32_t value) {
  switch (registers_.write(offset, value)) {
    case Request::Refused:
      return false;
    case Request::Reset:
      reset_requested_ = true;
      registers_.set(hw::kResetOffset, hw::kResetSoftResetMask);
      break;
    case Request::Snapshot:
      registers_.snapshot(engine_.counters());
      break;
    default:
      break;
  }
  notify();
  wake_.notify(sc_core::SC_ZERO_TIME);
  return true;
}

void HardwareModule::drive() {
  interrupt.write(registers_.interrupt());
}

void HardwareModule::work() {
  try {
    for (;;) serve();
  } catch (const sc_core::sc_unwind_exception&) {  // SystemC's own
    throw;
  } catch (const std::exception&) {
    fail();
  }
}

void HardwareModule::serve() {
  try {
    idle();
    check_rings();
    run_descriptor();
  } catch (const Stopped& stopped) {
    registers_.stop(stopped.code, in_job_ ? job_ : kNoJob, stopped.address);
    registers_.set_busy(false);
    registers_.set_result_blocked(false);
    notify();
  } catch (const Reset&) {
    reset();
  }
}

void HardwareModule::reset() {
  reset_requested_ = false;
  in_job_ = false;
  engine_.reset();
  clock_seen_ = clock_ ? clock_() : 0;
  registers_.reset();
  notify();
}

void HardwareModule::pause(const sc_core::sc_time& time) {
  const sc_core::sc_time end = sc_core::sc_time_stamp() + time;
  while (!reset_requested_ && sc_core::sc_time_stamp() < end) wait(end - sc_core::sc_time_stamp(), wake_);
  if (reset_requested_) throw Reset{};
}

void HardwareModule::pause_until_changed() {
  if (!reset_requested_) wait(wake_);
  if (reset_requested_) throw Reset{};
}

void HardwareModule::idle() {
  registers_.set_busy(false);
  while (registers_.stopped() || !registers_.enabled() ||
         registers_.get(hw::kCommandHeadOffset) == registers_.get(hw::kCommandTailOffset))
    pause_until_changed();
  registers_.set_busy(true);
}

void HardwareModule::check_rings() const {
  const auto is_ring = [&](std::uint32_t base, std::uint32_t log2, std::uint32_t place_bytes,
                           std::uint32_t low, std::uint32_t high) {
    return log2 >= low && log2 <= high &&
           registers_.get_address(base) % (std::uint64_t{place_bytes} << log2) == 0;
  };
  const auto fits = [&](std::uint32_t head, std::uint32_t tail, std::uint32_t log2) {
    return registers_.get(head) - registers_.get(tail) <= 1U << log2;
  };
  const std::uint32_t commands = registers_.get(hw::kCommandSizeOffset),
                      results = registers_.get(hw::kResultSizeOffset);
  if (!is_ring(hw::kCommandBaseLowOffset, commands, kDescriptorBytes, 1, 16) ||
      !is_ring(hw::kResultBaseLowOffset, results, sizeof(Word), 6, 28) ||
      !fits(hw::kCommandHeadOffset, hw::kCommandTailOffset, commands) ||
      !fits(hw::kResultHeadOffset, hw::kResultTailOffset, results))
    throw Stopped{hw::kErrorCodeIsBadRing, 0};
}

void HardwareModule::wait_for_reset() {
  for (;;) pause(cycles(kResetTimeout));
}

sc_core::sc_time HardwareModule::transfer(tlm::tlm_command command, std::uint64_t address,
                                          std::span<std::uint8_t> data) {
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(address);
  payload.set_data_ptr(data.data());
  payload.set_data_length(static_cast<unsigned>(data.size()));
  payload.set_streaming_width(static_cast<unsigned>(data.size()));
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  memory_socket_->b_transport(payload, delay);
  if (payload.is_response_ok()) return delay;
  if (payload.get_response_status() == tlm::TLM_INCOMPLETE_RESPONSE) {
    const std::uint32_t timeout = registers_.get(hw::kAxiTimeoutOffset);
    if (timeout == 0) wait_for_reset();
    pause(cycles(timeout));
    throw Stopped{hw::kErrorCodeIsTimeout, address};
  }
  pause(delay);
  const bool nowhere = payload.get_response_status() == tlm::TLM_ADDRESS_ERROR_RESPONSE;
  const bool is_read = command == tlm::TLM_READ_COMMAND;
  const std::uint32_t slave_error = is_read ? hw::kErrorCodeIsReadSlverr : hw::kErrorCodeIsWriteSlverr;
  throw Stopped{nowhere ? slave_error + 1 : slave_error, address};
}

HardwareModule::Descriptor HardwareModule::fetch_descriptor(std::uint64_t place) {
  std::array<Word, 2> words{};
  pause(transfer(tlm::TLM_READ_COMMAND, place, bytes_of(std::span(words))));
  return {words[0], static_cast<std::uint32_t>(words[1]), static_cast<std::uint16_t>(words[1] >> 32U),
          static_cast<std::uint16_t>(words[1] >> 48U)};
}

void HardwareModule::run_descriptor() {
  const std::uint32_t tail = registers_.get(hw::kCommandTailOffset);
  const std::uint32_t index = tail & ((1U << registers_.get(hw::kCommandSizeOffset)) - 1U);
  const std::uint64_t place =
      registers_.get_address(hw::kCommandBaseLowOffset) + std::uint64_t{index} * kDescriptorBytes;
  const Descriptor descriptor = fetch_descriptor(place);
  if (observe)
    observe({.cycle = to_cycles(sc_core::sc_time_stamp()),
             .job = descriptor.job,
             .words = descriptor.words,
             .flags = descriptor.flags,
             .address = descriptor.address});
  if (!in_job_) errors_ = flags_ = items_left_ = 0;
  in_job_ = true;
  job_ = descriptor.job;
  if (descriptor.words == 0 || descriptor.address % sizeof(Word) != 0 ||
      (descriptor.flags & ~(kLast | kInterrupt)) != 0)
    throw Stopped{hw::kErrorCodeIsBadDescriptor, 0};
  execute(descriptor);
  if ((descriptor.flags & kLast) != 0) {
    if (items_left_ != 0) throw Stopped{hw::kErrorCodeIsCutCommand, 0};
    complete(descriptor, place);
    in_job_ = false;
  }
  registers_.set(hw::kCommandTailOffset, tail + 1);
  notify();
}

/// A group of bursts is fetched while the engine works on the one before.
void HardwareModule::execute(const Descriptor& descriptor) {
  std::array<Word, std::size_t{kOutstanding} * kLineWords> group{};
  std::uint64_t address = descriptor.address;
  std::uint64_t left = descriptor.words, working = 0;
  while (left != 0) {
    std::size_t count = 0;
    sc_core::sc_time fetched = cycles(working);
    for (std::uint32_t burst = 0; burst < kOutstanding && left != 0; ++burst) {
      const std::uint64_t words = std::min<std::uint64_t>(left, (kLine - address % kLine) / sizeof(Word));
      fetched = std::max(fetched, transfer(tlm::TLM_READ_COMMAND, address,
                                           bytes_of(std::span(group).subspan(count, words))));
      address += words * sizeof(Word);
      left -= words;
      count += words;
    }
    pause(fetched);
    take(std::span(group).first(count));
    working = worked(count);
  }
  pause(cycles(working));
  give_results();
}

std::uint64_t HardwareModule::worked(std::uint64_t words) {
  if (!clock_) return words;
  const std::uint64_t now = clock_();
  return now - std::exchange(clock_seen_, now);
}

void HardwareModule::take(std::span<const Word> words) {
  for (const Word word : words)
    items_left_ = items_left_ != 0 ? items_left_ - 1 : golden::decode_header(word).count;
  engine_.submit(words);
  words_taken_ += words.size();
}

void HardwareModule::give_results() {
  std::vector<Word> results;
  engine_.drain([&](std::span<const Word> more) { results.insert(results.end(), more.begin(), more.end()); });
  pause(cycles(worked(0)));
  golden::ResultReader reader(results);
  while (const auto record = reader.next()) {
    if (golden::result_code(record->word) == golden::ResultCode::Error) ++errors_;
    if (golden::result_code(record->word) == golden::ResultCode::Fence)
      flags_ |= golden::decode_fence_result(record->word).sticky;
  }
  deliver(results);
}

/// In bursts that do not cross a line; waits while the ring is full.
void HardwareModule::deliver(std::span<const Word> results) {
  const std::uint32_t size = 1U << registers_.get(hw::kResultSizeOffset);
  const std::uint64_t base = registers_.get_address(hw::kResultBaseLowOffset);
  while (!results.empty()) {
    const std::uint32_t head = registers_.get(hw::kResultHeadOffset);
    const std::uint32_t room = size - (head - registers_.get(hw::kResultTailOffset));
    if (room == 0) {
      registers_.set_result_blocked(true);
      registers_.raise(hw::kInterruptStatusResultFullMask);
      notify();
      while (head - registers_.get(hw::kResultTailOffset) == size) pause_until_changed();
      registers_.set_result_blocked(false);
      continue;
    }
    const std::uint32_t to_line = kLineWords - head % kLineWords;
    const std::size_t count = std::min<std::size_t>({results.size(), room, to_line});
    std::array<Word, kLineWords> burst{};
    std::copy_n(results.begin(), count, burst.begin());
    pause(transfer(tlm::TLM_WRITE_COMMAND, base + std::uint64_t{head & (size - 1U)} * sizeof(Word),
                   bytes_of(std::span(burst).first(count))));
    registers_.set(hw::kResultHeadOffset, head + static_cast<std::uint32_t>(count));
    results = results.subspan(count);
  }
}

void HardwareModule::complete(const Descriptor& descriptor, std::uint64_t place) {
  const std::uint32_t flags = kComplete | descriptor.flags;
  std::array<Word, 2> words{registers_.get(hw::kResultHeadOffset) | std::uint64_t{flags_} << 32U,
                            errors_ | std::uint64_t{descriptor.job} << 32U | std::uint64_t{flags} << 48U};
  pause(transfer(tlm::TLM_WRITE_COMMAND, place, bytes_of(std::span(words))));
  registers_.set(hw::kJobFlagsOffset, flags_);
  registers_.set(hw::kJobsDoneOffset, registers_.get(hw::kJobsDoneOffset) + 1);
  if ((descriptor.flags & kInterrupt) != 0) registers_.raise(hw::kInterruptStatusJobDoneMask);
}

}  // namespace gnomon::sim::system
