// SPDX-License-Identifier: Apache-2.0
// The driver's functions on the mock registers.
#include <gtest/gtest.h>

#include <array>

#include "firmware/driver/gnomon_driver.h"
#include "sim/registers/registers.hpp"
#include "tests/firmware/host_platform.hpp"

namespace gnomon::firmware::test {
namespace {

namespace hw = sim::registers::hardware;

struct Driver : testing::Test {
  MockSystem system;
  HostPlatform platform{system};
  gnomon_device device{hw::kBase, {kCommandRing, 2}, {kResultRing, 8}, kPlanes, 0};
  sim::system::DeviceRegisters& registers = system.hardware.registers;

  gnomon_result probe() {
    gnomon_capabilities capabilities{};
    return gnomon_probe(&device, hw::kBase, &capabilities);
  }
  /// A NOP at the start of the words.
  std::uint32_t nop() {
    const std::array<golden::Word, 1> words{0};
    return system.place(words);
  }
  gnomon_result submit(std::uint32_t* place) { return gnomon_submit(&device, nop(), 1, 7, place); }
};

TEST_F(Driver, ProbesWhatItKnows) {
  gnomon_capabilities capabilities{};
  EXPECT_EQ(gnomon_probe(&device, hw::kBase, &capabilities), GNOMON_OK);
  EXPECT_EQ(capabilities.version, hw::kVersionReset);
  EXPECT_EQ(capabilities.features, hw::kFeaturesVpuOffsetMask | hw::kFeaturesRingsMask);
  EXPECT_EQ(capabilities.voxel_bits, 8);
  EXPECT_EQ(capabilities.normal_bits, 9);
  EXPECT_EQ(capabilities.plane_log2, 9);
  EXPECT_EQ(capabilities.depth_bits, 20);
  EXPECT_EQ(capabilities.slb_plane_log2, 0);
  EXPECT_EQ(system.register_writes, 0u);
}

TEST_F(Driver, RefusesWhatItDoesNotKnow) {
  registers.set(hw::kFeaturesOffset, hw::kFeaturesSlbMask);
  EXPECT_EQ(probe(), GNOMON_NO_RINGS);
  registers.set(hw::kVersionOffset, 0x00020000);
  EXPECT_EQ(probe(), GNOMON_WRONG_VERSION);
  registers.set(hw::kVersionOffset, 0x00010007);
  EXPECT_EQ(probe(), GNOMON_NO_RINGS) << "a later minor version is fine";
  registers.set(hw::kIdOffset, 0);
  EXPECT_EQ(probe(), GNOMON_NO_HARDWARE);
}

TEST_F(Driver, ChecksRingsBeforeItTouchesAnything) {
  const auto start_with = [&](gnomon_ring commands, gnomon_ring results) {
    device.commands = commands;
    device.results = results;
    return gnomon_start(&device, 0, 0);
  };
  const gnomon_ring good_commands{kCommandRing, 2}, good_results{kResultRing, 8};
  for (const gnomon_ring bad : {gnomon_ring{kCommandRing, 0}, {kCommandRing, 17}, {kCommandRing + 16, 2}})
    EXPECT_EQ(start_with(bad, good_results), GNOMON_BAD_RING) << bad.address << " " << bad.log2;
  for (const gnomon_ring bad : {gnomon_ring{kResultRing, 5}, {kResultRing, 29}, {kResultRing + 8, 8}})
    EXPECT_EQ(start_with(good_commands, bad), GNOMON_BAD_RING) << bad.address << " " << bad.log2;
  EXPECT_EQ(system.register_writes, 0u);
  EXPECT_EQ(start_with(good_commands, good_results), GNOMON_OK);
  EXPECT_EQ(registers.untimely_writes(), 0u);
  EXPECT_EQ(registers.get(hw::kControlOffset), hw::kControlEnableMask);
  EXPECT_EQ(registers.get(hw::kPlaneBaseLowOffset), kPlanes);
}

TEST_F(Driver, StartsOverWhereTheResultsWere) {
  ASSERT_EQ(gnomon_start(&device, 0xFFFFFFF0, 0xFFFFFFE0), GNOMON_OK);
  EXPECT_EQ(gnomon_results_head(&device), 0xFFFFFFF0u);
  EXPECT_EQ(registers.get(hw::kResultTailOffset), 0xFFFFFFE0u);
}

TEST_F(Driver, FillsTheRingAndNoFurther) {
  ASSERT_EQ(gnomon_start(&device, 0, 0), GNOMON_OK);
  std::uint32_t place = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(submit(&place), GNOMON_OK);
    EXPECT_EQ(place, i);
  }
  EXPECT_EQ(submit(&place), GNOMON_RING_FULL);
  EXPECT_EQ(registers.get(hw::kCommandHeadOffset), 4u);
  gnomon_completion completion{};
  EXPECT_FALSE(gnomon_complete(&device, 0, &completion));
  for (int i = 0; i < 3; ++i) system.advance(MockHardware::kCycles);
  EXPECT_TRUE(gnomon_complete(&device, 0, &completion));
  EXPECT_EQ(completion.job, 7);
  EXPECT_EQ(submit(&place), GNOMON_OK);
  EXPECT_EQ(place, 4u);
  EXPECT_FALSE(gnomon_complete(&device, 4, &completion)) << "the same place, used again";
}

TEST_F(Driver, TakesInterruptsOnce) {
  registers.set(hw::kInterruptStatusOffset, 5);
  EXPECT_EQ(gnomon_take_interrupts(&device), 5u);
  EXPECT_EQ(gnomon_take_interrupts(&device), 0u);
}

TEST_F(Driver, SaysWhyTheHardwareStopped) {
  ASSERT_EQ(gnomon_start(&device, 0, 0), GNOMON_OK);
  EXPECT_EQ(gnomon_error(&device), 0u);
  system.hardware.plan.push_back(Misbehaviour{.error = hw::kErrorCodeIsTimeout});
  std::uint32_t place = 0;
  ASSERT_EQ(submit(&place), GNOMON_OK);
  for (int i = 0; i < 3; ++i) system.advance(MockHardware::kCycles);
  EXPECT_EQ(gnomon_error(&device), hw::kErrorCodeIsTimeout | 7u << 16U);
  EXPECT_EQ(gnomon_reset(&device), GNOMON_OK);
  EXPECT_EQ(gnomon_error(&device), 0u) << "not stopped, though ERROR_STATUS stays";
  EXPECT_EQ(registers.get(hw::kErrorStatusOffset), hw::kErrorCodeIsTimeout | 7u << 16U);
}

TEST_F(Driver, GivesUpAResetThatDoesNotEnd) {
  system.hardware.reset_never_ends = true;
  EXPECT_EQ(gnomon_reset(&device), GNOMON_NO_RESET);
}

TEST_F(Driver, ReadsCountersOfOneMoment) {
  ASSERT_EQ(gnomon_start(&device, 0, 0), GNOMON_OK);
  std::uint32_t place = 0;
  ASSERT_EQ(submit(&place), GNOMON_OK);
  for (int i = 0; i < 3; ++i) system.advance(MockHardware::kCycles);
  EXPECT_EQ(gnomon_counter(&device, 0), 0u) << "COMMANDS, before the first snapshot";
  gnomon_take_snapshot(&device);
  EXPECT_EQ(gnomon_counter(&device, 0), 1u);
  registers.set(hw::kCounterHighOffset + 3 * hw::kCounterHighStride, 2);
  registers.set(hw::kCounterLowOffset + 3 * hw::kCounterLowStride, 1);
  EXPECT_EQ(gnomon_counter(&device, 3), 0x200000001u);
}

}  // namespace
}  // namespace gnomon::firmware::test
