// SPDX-License-Identifier: Apache-2.0
// Addresses, interrupt lines, and what a host does.
#include "tests/firmware/mock_system.hpp"

#include <cstring>

#include "sim/registers/registers.hpp"

namespace gnomon::firmware::test {

namespace hw = sim::registers::hardware;
namespace mb = sim::registers::mailbox;
namespace tm = sim::registers::timer;
using sim::cpu::Access;
using sim::cpu::Reply;

namespace {

constexpr std::uint32_t kBlock = 4096;

bool within(std::uint32_t address, std::uint32_t base) {
  return address - base < kBlock;
}

}  // namespace

MockSystem::MockSystem() : mailbox(mb::kRegisters), timer_(tm::kRegisters), next_words_(kWords) {
  set_up();
}

void MockSystem::set_up() {
  mailbox.set(mb::kCommandRingOffset, kCommandRing);
  mailbox.set(mb::kCommandRingLog2Offset, kCommandLog2);
  mailbox.set(mb::kResultRingOffset, kResultRing);
  mailbox.set(mb::kResultRingLog2Offset, result_log2);
  mailbox.set(mb::kJobTableOffset, kJobTable);
  mailbox.set(mb::kJobTableLog2Offset, kTableLog2);
  mailbox.set(mb::kPlanesOffset, kPlanes);
}

std::uint8_t* MockSystem::memory(std::uint32_t address, unsigned bytes) {
  if (address <= program.size() - bytes) return &program[address];
  return dram.holds(address, bytes) ? &dram.bytes[address - Dram::kBase] : nullptr;
}

Reply MockSystem::read(std::uint32_t address, unsigned bytes, Access) {
  if (const std::uint8_t* const at = memory(address, bytes)) {
    Reply reply;
    std::memcpy(&reply.data, at, bytes);
    return reply;
  }
  return bytes == 4 ? read_register(address) : Reply{0, 0, true};
}

Reply MockSystem::write(std::uint32_t address, unsigned bytes, std::uint32_t data) {
  if (std::uint8_t* const at = memory(address, bytes)) {
    std::memcpy(at, &data, bytes);
    return {};
  }
  return {0, 0, bytes != 4 || !write_register(address, data)};
}

Reply MockSystem::read_register(std::uint32_t address) {
  ++register_reads;
  std::optional<std::uint32_t> value;
  if (within(address, hw::kBase)) value = hardware.read(address - hw::kBase);
  if (within(address, mb::kBase)) value = mailbox.read(address - mb::kBase);
  if (within(address, tm::kBase)) {
    timer_.set(tm::kTimeLowOffset, static_cast<std::uint32_t>(time));
    timer_.set(tm::kTimeHighOffset, static_cast<std::uint32_t>(time >> 32U));
    value = timer_.read(address - tm::kBase);
  }
  return {value.value_or(0), 0, !value};
}

bool MockSystem::write_register(std::uint32_t address, std::uint32_t data) {
  ++register_writes;
  if (within(address, hw::kBase)) return hardware.write(address - hw::kBase, data);
  if (within(address, tm::kBase)) return timer_.write(address - tm::kBase, data);
  if (!within(address, mb::kBase)) return false;
  if (address == mb::kBase + mb::kLogOffset) log += static_cast<char>(data);
  return mailbox.write(address - mb::kBase, data);
}

void MockSystem::advance(std::uint64_t cycles) {
  time += cycles;
  hardware.advance(cycles);
}

Lines MockSystem::lines() const {
  const std::uint64_t compare =
      timer_.get(tm::kCompareLowOffset) | std::uint64_t{timer_.get(tm::kCompareHighOffset)} << 32U;
  return {hardware.interrupt(), mailbox.get(mb::kDoorbellOffset) != 0, time >= compare};
}

std::uint32_t MockSystem::place(std::span<const golden::Word> words) {
  const std::uint32_t at = next_words_;
  for (const golden::Word word : words) {
    dram.set_word(next_words_, word);
    next_words_ += 8;
  }
  return at;
}

void MockSystem::post(const gnomon_job& job) {
  const std::uint32_t number = mailbox.get(mb::kJobsPostedOffset);
  const std::size_t at = kJobTable + number % (1U << kTableLog2) * sizeof job;
  std::memcpy(&dram.bytes[at - Dram::kBase], &job, sizeof job);
  mailbox.set(mb::kJobsPostedOffset, number + 1);
  ring();
}

void MockSystem::ring() {
  mailbox.set(mb::kDoorbellOffset, 1);
}

gnomon_job MockSystem::job(std::uint32_t number) const {
  gnomon_job job{};
  std::memcpy(&job, &dram.bytes[kJobTable - Dram::kBase + number % (1U << kTableLog2) * sizeof job],
              sizeof job);
  return job;
}

std::uint32_t MockSystem::finished() const {
  return mailbox.get(mb::kJobsFinishedOffset);
}

void MockSystem::take_results() {
  const std::uint32_t ready = mailbox.get(mb::kResultsReadyOffset);
  if (taken_.size() == ready) return;
  while (taken_.size() != ready)
    taken_.push_back(dram.word(kResultRing + (taken_.size() & ((1U << result_log2) - 1U)) * 8));
  mailbox.set(mb::kResultsTakenOffset, ready);
  ring();
}

std::vector<golden::Word> MockSystem::results(std::uint32_t begin, std::uint32_t end) const {
  return {taken_.begin() + begin, taken_.begin() + end};
}

}  // namespace gnomon::firmware::test
