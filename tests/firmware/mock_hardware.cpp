// SPDX-License-Identifier: Apache-2.0
// Descriptor by descriptor: begin, execute on golden, deliver results, complete.
#include "tests/firmware/mock_hardware.hpp"

#include <algorithm>
#include <cstring>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>

#include "sim/registers/registers.hpp"

namespace gnomon::firmware::test {

namespace hw = sim::registers::hardware;

namespace {

constexpr std::uint32_t kLast = 1, kInterrupt = 2, kKnownFlags = kLast | kInterrupt, kComplete = 0x8000;

/// Of a descriptor in the command ring.
std::uint64_t place(std::uint64_t base, std::uint32_t log2, std::uint32_t count) {
  return base + std::uint64_t{count & ((1U << log2) - 1U)} * 16;
}

}  // namespace

std::uint64_t Dram::word(std::uint64_t address) const {
  std::uint64_t value = 0;
  std::memcpy(&value, &bytes.at(address - kBase), sizeof value);
  return value;
}

void Dram::set_word(std::uint64_t address, std::uint64_t value) {
  std::memcpy(&bytes.at(address - kBase), &value, sizeof value);
}

MockHardware::MockHardware(Dram& dram)
    : registers(golden::HardwareConfig{}),
      dram_(dram),
      engine_(golden::make_golden_engine(golden::HardwareConfig{})) {}

bool MockHardware::write(std::uint32_t offset, std::uint32_t value) {
  switch (registers.write(offset, value)) {
    case sim::system::Request::Refused:
      return false;
    case sim::system::Request::Reset:
      reset();
      break;
    case sim::system::Request::Snapshot:
      registers.snapshot(engine_->counters());
      break;
    default:
      break;
  }
  return true;
}

void MockHardware::reset() {
  ++resets;
  registers.reset();
  registers.set(hw::kResetOffset, reset_never_ends ? 1 : 0);
  engine_->reset();
  blocked_ = false;
  ends_in_.reset();
  waiting_.clear();
  executed_ = false;
}

void MockHardware::advance(std::uint64_t cycles) {
  if (registers.stopped()) return;
  if (executed_) return deliver();
  if (!ends_in_) return begin();
  if (misbehaviour_.never_ends) return;
  *ends_in_ -= std::min(*ends_in_, cycles);
  if (*ends_in_ == 0) finish();
}

void MockHardware::begin() {
  if (!registers.enabled() || get(hw::kCommandHeadOffset) == get(hw::kCommandTailOffset)) return;
  misbehaviour_ = {};
  if (!plan.empty()) {
    misbehaviour_ = plan.front();
    plan.pop_front();
  }
  registers.set_busy(true);
  ends_in_ = kCycles;
  errors_ = 0;
  flags_ = misbehaviour_.flags;
}

void MockHardware::finish() {
  const std::uint64_t at = place(registers.get_address(hw::kCommandBaseLowOffset),
                                 get(hw::kCommandSizeOffset), get(hw::kCommandTailOffset));
  if (!dram_.holds(at, 16)) return stop(hw::kErrorCodeIsReadDecerr, static_cast<std::uint32_t>(at));
  const std::uint64_t from = dram_.word(at), rest = dram_.word(at + 8);
  const auto words = static_cast<std::uint32_t>(rest);
  job_ = static_cast<std::uint16_t>(rest >> 32U);
  const auto flags = static_cast<std::uint32_t>(rest >> 48U);
  if (words == 0 || from % 8 != 0 || (flags & ~kKnownFlags) != 0)
    return stop(hw::kErrorCodeIsBadDescriptor, 0);
  if (!dram_.holds(from, std::uint64_t{words} * 8))
    return stop(hw::kErrorCodeIsReadDecerr, static_cast<std::uint32_t>(from));
  execute(from, words);
  executed_ = true;
  deliver();
}

void MockHardware::execute(std::uint64_t from, std::uint32_t words) {
  std::vector<golden::Word> stream(words);
  for (std::uint32_t i = 0; i < words; ++i) stream[i] = dram_.word(from + std::uint64_t{i} * 8);
  engine_->submit(stream);
  engine_->drain([&](std::span<const golden::Word> results) {
    for (const golden::Word word : results) {
      waiting_.push_back(word);
      if (golden::result_code(word) == golden::ResultCode::Error) ++errors_;
      if (golden::result_code(word) == golden::ResultCode::Fence)
        flags_ |= golden::decode_fence_result(word).sticky;
    }
  });
  if (misbehaviour_.error != 0) waiting_.resize(waiting_.size() / 2);
}

void MockHardware::deliver() {
  const std::uint32_t log2 = get(hw::kResultSizeOffset);
  std::uint32_t head = get(hw::kResultHeadOffset);
  for (; !waiting_.empty(); ++head) {
    if (head - get(hw::kResultTailOffset) == 1U << log2) {
      if (!blocked_) registers.raise(hw::kInterruptStatusResultFullMask);
      blocked_ = true;
      registers.set(hw::kResultHeadOffset, head);
      return;
    }
    dram_.set_word(
        registers.get_address(hw::kResultBaseLowOffset) + std::uint64_t{head & ((1U << log2) - 1U)} * 8,
        waiting_.front());
    waiting_.pop_front();
    blocked_ = false;
  }
  registers.set(hw::kResultHeadOffset, head);
  if (misbehaviour_.error != 0) return stop(misbehaviour_.error, misbehaviour_.address);
  complete();
}

void MockHardware::complete() {
  const std::uint32_t tail = get(hw::kCommandTailOffset);
  const std::uint64_t at =
      place(registers.get_address(hw::kCommandBaseLowOffset), get(hw::kCommandSizeOffset), tail);
  const std::uint64_t before = dram_.word(at + 8);
  dram_.set_word(at, get(hw::kResultHeadOffset) | std::uint64_t{flags_} << 32U);
  dram_.set_word(at + 8, before >> 32U << 32U | errors_ | std::uint64_t{kComplete} << 48U);
  registers.set(hw::kJobFlagsOffset, flags_);
  registers.set(hw::kJobsDoneOffset, get(hw::kJobsDoneOffset) + 1);
  registers.set(hw::kCommandTailOffset, tail + 1);
  registers.set_busy(false);
  ends_in_.reset();
  executed_ = false;
  if ((before >> 48U & kInterrupt) != 0) registers.raise(hw::kInterruptStatusJobDoneMask);
}

void MockHardware::stop(std::uint32_t code, std::uint32_t address) {
  registers.stop(code, job_, address);
  registers.set_busy(false);
  ends_in_.reset();
  waiting_.clear();
  executed_ = false;
}

}  // namespace gnomon::firmware::test
