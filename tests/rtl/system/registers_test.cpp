// SPDX-License-Identifier: Apache-2.0
// The registers of gnomon_top as docs/registers.md and docs/system.md say: what is there, what may be written
// when.
#include <gtest/gtest.h>

#include <algorithm>

#include "Vsystem_cached.h"
#include "Vsystem_narrow.h"
#include "Vsystem_wide.h"
#include "jobs.hpp"

namespace gnomon::rtl_test {
namespace {

constexpr unsigned kOkay = 0, kSlverr = 2;

const sim::registers::RegisterInfo* find(std::uint32_t offset) {
  for (const auto& info : hw::kRegisters) {
    const std::uint32_t place = offset - info.offset;
    if (offset >= info.offset && place % info.stride == 0 && place / info.stride < info.count) return &info;
  }
  return nullptr;
}

template <class Model>
class SystemRegisters : public testing::Test {};
using Builds = testing::Types<Vsystem_narrow, Vsystem_wide, Vsystem_cached>;
TYPED_TEST_SUITE(SystemRegisters, Builds);

TYPED_TEST(SystemRegisters, SayWhatTheBuildHas) {
  TopBench<TypeParam> bench(1);
  constexpr bool kHasCache = std::is_same_v<TypeParam, Vsystem_cached>;
  const golden::HardwareConfig config = kHasCache ? kCached : kSmall;
  EXPECT_EQ(bench.read(hw::kIdOffset), hw::kIdReset);
  EXPECT_EQ(bench.read(hw::kVersionOffset), hw::kVersionReset);
  EXPECT_EQ(bench.read(hw::kFeaturesOffset), hw::kFeaturesVpuOffsetMask | hw::kFeaturesRingsMask |
                                                 hw::kFeaturesStreamPortsMask |
                                                 (kHasCache ? hw::kFeaturesCacheMask : 0u));
  const auto bytes = [](int a, int b, int c, int d) {
    return static_cast<std::uint32_t>(a | b << 8 | c << 16 | d << 24);
  };
  EXPECT_EQ(bench.read(hw::kWidthsVoxelOffset),
            bytes(config.voxel_bits, config.voxel_frac_bits, config.normal_bits, config.matrix_frac_bits));
  EXPECT_EQ(bench.read(hw::kWidthsPlaneOffset), bytes(config.plane_log2, config.depth_bits, 0, 0));
  EXPECT_EQ(bench.read(hw::kWidthsSlbOffset), 0u);
  EXPECT_EQ(bench.read(hw::kWidthsMemoryOffset),
            bytes(std::is_same_v<TypeParam, Vsystem_wide> ? 6 : 3, kHasCache ? 12 : 0, kHasCache ? 5 : 0, 0));
}

TEST(SystemRegisterMap, IsThatOfTheTableAndNothingElse) {
  TopBench<Vsystem_narrow> bench(1);
  unsigned there = 0;
  for (std::uint32_t offset = 0; offset < 4096; offset += 4) {
    const auto* info = find(offset);
    const Access access = bench.access(offset);
    EXPECT_EQ(access.response, info != nullptr ? kOkay : kSlverr) << offset;
    if (info != nullptr && info->reset != 0) {
      EXPECT_EQ(access.value, info->reset) << info->name;
    }
    EXPECT_EQ(bench.write(offset, 0), info != nullptr ? kOkay : kSlverr) << offset;
    there += info != nullptr ? 1 : 0;
  }
  std::uint32_t expected = 0;
  for (const auto& info : hw::kRegisters) expected += info.count;
  EXPECT_EQ(there, expected);
  for (const std::uint32_t offset : {1u, 2u, 0x41u, 0x402u}) {
    EXPECT_EQ(bench.access(offset).response, kSlverr);
    EXPECT_EQ(bench.write(offset, 1), kSlverr);
  }
}

TEST(SystemRegisterMap, HoldsWhatIsWrittenWhereSoftwareMay) {
  TopBench<Vsystem_narrow> bench(1);
  for (const auto& info : hw::kRegisters) {
    if (info.offset == hw::kResetOffset || info.offset == hw::kControlOffset) continue;
    const std::uint32_t before = bench.read(info.offset);
    EXPECT_EQ(bench.write(info.offset, 0xA5A5F00F), kOkay);
    std::uint32_t expected = before;
    if (info.access == sim::registers::Access::Rw) expected = 0xA5A5F00F & info.mask;
    if (info.offset == hw::kPlaneBaseLowOffset) expected &= ~0xFFFu;
    EXPECT_EQ(bench.read(info.offset), expected) << info.name;
  }
  // Strobes that are not all there change nothing.
  EXPECT_EQ(bench.write(hw::kCommandSizeOffset, 3, 7), kSlverr);
  EXPECT_EQ(bench.read(hw::kCommandSizeOffset), 0xFu);
  ASSERT_TRUE(bench.reset());
  for (const auto& info : hw::kRegisters) {
    if (info.count == 1 && info.access == sim::registers::Access::Rw) {
      EXPECT_EQ(bench.read(info.offset), info.reset) << info.name;
    }
  }
}

TEST(SystemRegisterMap, FreezesWhatSetsUpTheRings) {
  TopBench<Vsystem_narrow> bench(1);
  bench.start({}, 1000);
  for (const std::uint32_t offset :
       {hw::kPlaneBaseLowOffset, hw::kPlaneBaseHighOffset, hw::kCommandBaseLowOffset,
        hw::kCommandBaseHighOffset, hw::kCommandSizeOffset, hw::kCommandTailOffset, hw::kResultBaseLowOffset,
        hw::kResultBaseHighOffset, hw::kResultSizeOffset, hw::kResultHeadOffset}) {
    const std::uint32_t before = bench.read(offset);
    EXPECT_EQ(bench.write(offset, ~before), kOkay);
    EXPECT_EQ(bench.read(offset), before) << offset;
  }
}

/// Runs until the line is up or so many cycles have passed.
bool wait_for_line(TopBench<Vsystem_narrow>& bench, unsigned limit) {
  for (unsigned i = 0; i < limit && !bench.interrupt(); ++i) bench.clock();
  return bench.interrupt();
}

TEST(SystemInterrupts, FollowStatusAndEnable) {
  TopBench<Vsystem_narrow> bench(2);
  bench.start({}, 1000);
  bench.submit(random_job(kSmall, 1, 10), 1, 1);
  ASSERT_TRUE(wait_for_line(bench, 50'000));
  EXPECT_EQ(bench.read(hw::kInterruptStatusOffset), hw::kInterruptStatusJobDoneMask);
  bench.write(hw::kInterruptEnableOffset, 6);
  EXPECT_FALSE(bench.interrupt());
  bench.write(hw::kInterruptEnableOffset, 1);
  EXPECT_TRUE(bench.interrupt());
  bench.write(hw::kInterruptStatusOffset, 6);  // of others
  EXPECT_TRUE(bench.interrupt());
  bench.write(hw::kInterruptStatusOffset, 1);
  EXPECT_FALSE(bench.interrupt());
  EXPECT_EQ(bench.read(hw::kInterruptStatusOffset), 0u);
}

TEST(SystemInterrupts, TellOfAFullRingAndGoOnWhereItIsEmptied) {
  TopBench<Vsystem_narrow> bench(3);
  bench.start({.command_log2 = 2, .result_log2 = 6}, 300, 5);  // the ring's end is not a line's
  Reference reference(kSmall);
  const std::vector<Word> words = random_job(kSmall, 7, 60), expected = reference.run(words);
  ASSERT_GT(expected.size(), 200u);
  bench.submit(words, 1, 1);
  std::vector<Word> results;
  unsigned full = 0;
  while (results.size() < expected.size()) {
    ASSERT_TRUE(wait_for_line(bench, 50'000));
    const std::uint32_t status = bench.read(hw::kInterruptStatusOffset);
    bench.write(hw::kInterruptStatusOffset, status);
    if ((status & hw::kInterruptStatusResultFullMask) != 0) {
      ++full;
      bench.run(2000);  // longer than AXI_TIMEOUT: it is software that is waited for
      EXPECT_EQ(bench.read(hw::kStatusOffset), hw::kStatusResultBlockedMask);
      EXPECT_EQ(bench.read(hw::kResultHeadOffset), results.size() + 5 + 64) << "all places are filled";
    }
    bench.take_results(results);
  }
  EXPECT_EQ(results, expected);
  EXPECT_GE(full, expected.size() / 64 - 1);
  EXPECT_FALSE(bench.stopped());
}

}  // namespace
}  // namespace gnomon::rtl_test
