// SPDX-License-Identifier: Apache-2.0
// What only the image has: log, sleep, traps, size, instructions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "sim/registers/registers.hpp"
#include "tests/firmware/machines.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::firmware::test {
namespace {

namespace hw = sim::registers::hardware;
namespace mb = sim::registers::mailbox;

TEST(Image, SaysWhatItHasFound) {
  ImageMachine machine;
  machine.start();
  EXPECT_EQ(machine.system.mailbox.get(mb::kStateOffset), mb::kStateIsReady);
  EXPECT_EQ(machine.system.log,
            "gnomon firmware: hardware 1.1, features 0x40002, voxels 2^8, plane 2^9, depth 20 bits\n");
}

TEST(Image, SaysWhyItCannotGoOn) {
  const auto failure_with = [](std::uint32_t offset, std::uint32_t value) {
    ImageMachine machine;
    machine.system.hardware.registers.set(offset, value);
    machine.start();
    return failure(machine.system);
  };
  EXPECT_EQ(failure_with(hw::kIdOffset, 1), mb::kFailureIsNoHardware);
  EXPECT_EQ(failure_with(hw::kVersionOffset, 0x50000), mb::kFailureIsWrongVersion);
  EXPECT_EQ(failure_with(hw::kFeaturesOffset, 0), mb::kFailureIsNoRings);
}

TEST(Image, SleepsWhenThereIsNothingToDo) {
  ImageMachine machine;
  machine.start();
  for (int i = 0; i < 3; ++i) machine.step();
  const sim::cpu::Counters before = machine.core.counters();
  for (int i = 0; i < 1000; ++i) machine.step();
  const sim::cpu::Counters after = machine.core.counters();
  EXPECT_EQ(after.instructions, before.instructions);
  EXPECT_EQ(after.cycles_asleep - before.cycles_asleep, 100'000u);
}

TEST(Image, ReportsAnExceptionOfItsOwn) {
  ImageMachine machine;
  machine.start();
  for (std::size_t i = 0; i < 0x200; ++i) machine.system.program[0xF000 + i] = 0;
  sim::cpu::HartState state = machine.core.state();
  state.pc = 0xF000;  // zeros: an illegal instruction
  machine.core.set_state(state);
  machine.core.set_interrupt(sim::cpu::Interrupt::Software, true);  // wakes it
  for (int i = 0; i < 100 && failure(machine.system) == 0; ++i) machine.core.run(100);
  EXPECT_EQ(failure(machine.system), mb::kFailureIsTrap);
  EXPECT_THAT(machine.system.log, testing::HasSubstr("trap: cause 2 at 0x0000f000, value 0x00000000\n"));
}

TEST(Image, IsSmallAndQuick) {
  ImageMachine machine;
  machine.start();
  const std::uint64_t start = machine.core.counters().instructions;
  const std::vector<golden::Word> words = stimulus::random_stream({}, {.seed = 3, .commands = 20});
  gnomon_job job{};
  job.address = machine.system.place(words);
  job.words = static_cast<std::uint32_t>(words.size());
  machine.system.post(job);
  ASSERT_TRUE(run_jobs(machine, 1));
  const std::uint32_t instructions = machine.system.job(0).instructions;
  const auto bytes = std::filesystem::file_size(GNOMON_FIRMWARE_IMAGE);
  RecordProperty("image_bytes", static_cast<int>(bytes));
  RecordProperty("instructions_to_start", static_cast<int>(start));
  RecordProperty("instructions_per_job", static_cast<int>(instructions));
  std::printf("image %d bytes; %d instructions to start, %d for a job\n", static_cast<int>(bytes),
              static_cast<int>(start), static_cast<int>(instructions));
  EXPECT_LT(bytes, 8'192u);
  EXPECT_GT(instructions, 100u);
  EXPECT_LT(instructions, 1'000u);
}

}  // namespace
}  // namespace gnomon::firmware::test
