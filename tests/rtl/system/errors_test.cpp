// SPDX-License-Identifier: Apache-2.0
// Jobs and rings that are wrong, stopping, enabling and resetting: what the hardware says and does.
#include <gtest/gtest.h>

#include <gnomon/golden/codec.hpp>

#include "Vsystem_narrow.h"
#include "jobs.hpp"
#include "sim/counter_names.hpp"

namespace gnomon::rtl_test {
namespace {

using Bench = TopBench<Vsystem_narrow>;
constexpr std::uint32_t kTimeout = 500;

std::uint64_t error_address(Bench& bench) {
  return bench.read(hw::kErrorAddressLowOffset) | std::uint64_t{bench.read(hw::kErrorAddressHighOffset)}
                                                      << 32;
}

/// Waits for the stop and checks what is said of it.
void expect_stop(Bench& bench, std::uint32_t code, std::uint32_t job) {
  std::vector<Word> results;
  ASSERT_TRUE(bench.wait(results));
  ASSERT_TRUE(bench.stopped());
  EXPECT_EQ(bench.read(hw::kErrorStatusOffset), code | job << 16);
}

TEST(SystemErrors, RingsThatAreNone) {
  struct Case {
    std::uint32_t offset, value;
  };
  const std::uint32_t low = static_cast<std::uint32_t>(Rings{}.base);
  for (const Case& wrong :
       {Case{hw::kCommandSizeOffset, 0}, Case{hw::kCommandSizeOffset, 17}, Case{hw::kResultSizeOffset, 5},
        Case{hw::kResultSizeOffset, 29}, Case{hw::kCommandBaseLowOffset, low + 128},
        Case{hw::kResultBaseLowOffset, low + 2048}, Case{hw::kCommandTailOffset, 0xFFFF'FFE0},
        Case{hw::kResultTailOffset, 0xFFFF'FDFF}}) {
    Bench bench(1);
    bench.start({}, kTimeout);
    bench.write(hw::kControlOffset, 0);
    bench.write(wrong.offset, wrong.value);
    bench.write(hw::kControlOffset, hw::kControlEnableMask);
    bench.run(50);
    EXPECT_EQ(bench.stopped(), wrong.offset == hw::kCommandTailOffset) << "else there is nothing to do yet";
    bench.write(hw::kCommandHeadOffset, 1);
    expect_stop(bench, hw::kErrorCodeIsBadRing, 0xFFFF);
    EXPECT_EQ(error_address(bench), 0u);
  }
}

TEST(SystemErrors, DescriptorsThatAreNone) {
  const std::uint64_t words = Rings{}.words();
  struct Case {
    std::uint64_t address;
    std::uint32_t count;
    std::uint16_t flags;
  };
  for (const Case& wrong :
       {Case{words, 0, 1}, Case{words + 4, 1, 1}, Case{words, 1, 5}, Case{words, 1, 0x8001}}) {
    Bench bench(1);
    bench.start({}, kTimeout);
    bench.put_descriptor(wrong.address, wrong.count, 77, wrong.flags);
    bench.write(hw::kCommandHeadOffset, bench.head());
    expect_stop(bench, hw::kErrorCodeIsBadDescriptor, 77);
    EXPECT_EQ(bench.read(hw::kCommandTailOffset), 0u);
  }
}

TEST(SystemErrors, WordsThatEndWithinACommand) {
  Bench bench(1);
  bench.start({}, kTimeout);
  const std::vector<Word> words{golden::Word{0x01} << 56 | golden::Word{5} << 32, 1, 2, 3};
  bench.submit(words, 9, 2);
  expect_stop(bench, hw::kErrorCodeIsCutCommand, 9);
  EXPECT_EQ(bench.read(hw::kJobsDoneOffset), 0u);
}

TEST(SystemErrors, StoppedHardwareHeedsNothingButItsReset) {
  Bench bench(1);
  bench.start({}, kTimeout);
  bench.put_descriptor(Rings{}.words(), 0, 4, 1);
  bench.write(hw::kCommandHeadOffset, bench.head());
  expect_stop(bench, hw::kErrorCodeIsBadDescriptor, 4);
  for (const std::uint32_t offset :
       {hw::kControlOffset, hw::kCommandHeadOffset, hw::kResultTailOffset, hw::kAxiTimeoutOffset,
        hw::kInterruptEnableOffset, hw::kCommandBaseLowOffset}) {
    const std::uint32_t before = bench.read(offset);
    bench.write(offset, ~before);
    EXPECT_EQ(bench.read(offset), before) << offset;
  }
  ASSERT_TRUE(bench.reset());
  EXPECT_FALSE(bench.stopped());
  EXPECT_EQ(bench.read(hw::kErrorStatusOffset), hw::kErrorCodeIsBadDescriptor | 4u << 16)
      << "survives the reset";
  EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask);
  EXPECT_EQ(bench.read(hw::kInterruptStatusOffset), 0u);
}

/// The address of a transaction in error is that of its first beat.
TEST(SystemErrors, NameTheTransaction) {
  for (const auto& [fault, code] : {std::pair{Fault::ReadSlverr, hw::kErrorCodeIsReadSlverr},
                                    std::pair{Fault::ReadDecerr, hw::kErrorCodeIsReadDecerr},
                                    std::pair{Fault::WriteSlverr, hw::kErrorCodeIsWriteSlverr},
                                    std::pair{Fault::WriteDecerr, hw::kErrorCodeIsWriteDecerr},
                                    std::pair{Fault::ReadSilent, hw::kErrorCodeIsTimeout},
                                    std::pair{Fault::WriteSilent, hw::kErrorCodeIsTimeout}}) {
    for (const unsigned skip : {0u, 1u, 3u}) {
      Bench bench(1);
      bench.memory().set_timing({10, 40, 200, true});
      bench.start({}, kTimeout, 3);
      bench.memory().inject(fault, skip);
      bench.submit(random_job(kSmall, 5, 40), 12, 1, 5);
      std::vector<Word> results;
      ASSERT_TRUE(bench.wait(results));
      ASSERT_TRUE(bench.stopped());
      EXPECT_EQ(bench.read(hw::kErrorStatusOffset) & 0xFF, code);
      EXPECT_EQ(error_address(bench), bench.memory().fault_address());
    }
  }
}

TEST(SystemErrors, NoTimeoutWaitsAndAResetEndsItAllTheSame) {
  Bench bench(1);
  bench.start({}, 0);
  bench.memory().inject(Fault::ReadSilent, 1);
  bench.submit(random_job(kSmall, 1, 10), 1, 1);
  bench.run(100'000);
  EXPECT_FALSE(bench.stopped());
  EXPECT_EQ(bench.read(hw::kStatusOffset), 0u);
  const std::uint64_t before = bench.cycles();
  ASSERT_TRUE(bench.reset());
  EXPECT_GE(bench.cycles() - before, 65'536u);
  EXPECT_LT(bench.cycles() - before, 65'700u);
  EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask | hw::kStatusLateMask);
  bench.memory().heal();
  bench.run(200);
  EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask);
}

/// Two epochs with answers due: the third begins all the same, and is right.
TEST(SystemErrors, GivesUpTwice) {
  Bench bench(1);
  for (int round = 0; round < 3; ++round) {
    bench.start({}, 200);
    bench.memory().inject(Fault::ReadSilent, 1);
    bench.submit(random_job(kSmall, 1, 10), 1, 1);
    std::vector<Word> results;
    ASSERT_TRUE(bench.wait(results));
    EXPECT_EQ(bench.read(hw::kErrorStatusOffset) & 0xFF, hw::kErrorCodeIsTimeout);
    ASSERT_TRUE(bench.reset());
  }
  EXPECT_FALSE(bench.asserted());
}

/// Hundreds of beats are under way, and the next one comes within AXI_TIMEOUT each time: nothing is given up,
/// however long all of them take.
TEST(SystemErrors, AResetWaitsForAMemoryThatIsSlowButMoves) {
  Bench bench(3);
  bench.memory().set_timing({40, 40, 20, false});
  bench.start({}, kTimeout);
  bench.submit(random_job(kSmall, 5, 60), 1, 1);
  bench.run(1'000);
  const std::uint64_t before = bench.cycles();
  ASSERT_TRUE(bench.reset());
  EXPECT_GT(bench.cycles() - before, 2 * kTimeout) << "else this shows nothing";
  EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask) << "no late answers";
  EXPECT_TRUE(bench.memory().quiet());
}

/// Whatever ends in the cycle of a reset, or in those after it: it is not counted in the registers, which are
/// at their reset values when it is over.
TEST(SystemErrors, AResetInAnyCycleOfAJobLeavesNoCount) {
  Bench bench(1);
  const std::vector<Word> words(3, golden::encode(golden::Header{0, 0, 0, 0}));
  unsigned within = 0;
  for (unsigned delay = 0; delay < 200; ++delay) {
    bench.start({}, kTimeout);
    bench.submit(words, 1, 3);  // descriptors of a word each
    bench.run(delay);
    within += bench.interrupt() ? 0U : 1U;
    ASSERT_TRUE(bench.reset());
    for (const std::uint32_t offset : {hw::kCommandHeadOffset, hw::kCommandTailOffset, hw::kResultHeadOffset,
                                       hw::kJobsDoneOffset, hw::kInterruptStatusOffset, hw::kControlOffset})
      ASSERT_EQ(bench.read(offset), 0U) << "register " << offset << ", reset after " << delay;
    ASSERT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask);
  }
  EXPECT_GT(within, 30U) << "resets while the job ran";
  EXPECT_LT(within, 190U) << "the job ends";
}

TEST(SystemControl, DisabledHardwareFinishesWhatItHasBegun) {
  Bench bench(2);
  bench.memory().set_timing({20, 20, 256, false});
  bench.start({}, kTimeout);
  Reference reference(kSmall);
  std::vector<Word> expected;
  const std::vector<Word> words = random_job(kSmall, 3, 30);
  std::uint64_t address = Rings{}.words();
  for (std::uint16_t job = 0; job < 3; ++job) {
    for (std::size_t i = 0; i < words.size(); ++i) bench.memory().set_word(address + 8 * i, words[i]);
    bench.put_descriptor(address, static_cast<std::uint32_t>(words.size()), job, 3);
    address += 8 * words.size();
    const auto some = reference.run(words);
    expected.insert(expected.end(), some.begin(), some.end());
  }
  bench.write(hw::kCommandHeadOffset, bench.head());
  std::vector<Word> results;
  bench.run(100);
  bench.write(hw::kControlOffset, 0);
  EXPECT_EQ(bench.read(hw::kStatusOffset), 0u) << "busy with the first";
  ASSERT_TRUE(bench.wait(results));
  bench.run(500);
  EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusIdleMask);
  EXPECT_EQ(bench.read(hw::kCommandTailOffset), 1u);
  bench.write(hw::kControlOffset, hw::kControlEnableMask);
  while (bench.read(hw::kJobsDoneOffset) != 3) ASSERT_TRUE(bench.wait(results));
  bench.take_results(results);
  EXPECT_EQ(results, expected);
}

/// Cycles of all passes with a cause.
std::uint64_t cycles_of(Bench& bench, std::size_t cause) {
  std::uint64_t sum = 0;
  for (std::size_t pass = 0; pass < sim::kPassNames.size(); ++pass)
    sum += bench.counter(static_cast<unsigned>(sim::cycle_counter_index(pass, cause)));
  return sum;
}

TEST(SystemAccount, WaitingForTheBusIsMemoryWait) {
  struct Cycles {
    std::uint64_t starved, blocked, memory;
  };
  const auto cycles = [](unsigned latency) {
    Bench bench(4);
    bench.memory().set_timing({latency, latency, 256, false});
    bench.start({.command_log2 = 4, .result_log2 = 13}, 0);
    bench.run(2000);  // the clear after reset
    std::vector<Word> results;
    bench.submit(random_job(kSmall, 11, 100), 1, 1);
    EXPECT_TRUE(bench.wait(results, 500'000));
    bench.write(hw::kSnapshotOffset, 1);
    return Cycles{cycles_of(bench, 1), cycles_of(bench, 2), cycles_of(bench, 3)};
  };
  const Cycles quick = cycles(1), slow = cycles(3000);
  EXPECT_LT(quick.memory + 5'000, slow.memory);
  EXPECT_LE(slow.starved, quick.starved + 10);
  EXPECT_EQ(quick.blocked, 0u);
  EXPECT_EQ(slow.blocked, 0u);
}

}  // namespace
}  // namespace gnomon::rtl_test
