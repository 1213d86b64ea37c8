// SPDX-License-Identifier: Apache-2.0
// What may be written when; stop and reset (docs/system.md).
#include "sim/system/device_registers.hpp"

#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>

#include "sim/registers/registers.hpp"

namespace gnomon::sim::system::test {
namespace {

namespace hw = registers::hardware;

struct Device : testing::Test {
  golden::HardwareConfig config;
  DeviceRegisters registers{config};
};

TEST_F(Device, DescribesItsBuild) {
  config.en_slb = true;
  config.en_vpu_topology = true;
  config.en_perspective = true;
  config.en_frame_buffer = true;
  const DeviceRegisters full(config);
  EXPECT_EQ(registers.get(hw::kFeaturesOffset), hw::kFeaturesVpuOffsetMask | hw::kFeaturesRingsMask);
  EXPECT_EQ(registers.get(hw::kWidthsSlbOffset), 0u);
  EXPECT_EQ(full.get(hw::kFeaturesOffset), registers.get(hw::kFeaturesOffset) | hw::kFeaturesSlbMask |
                                               hw::kFeaturesPerspectiveMask | hw::kFeaturesFrameBufferMask |
                                               hw::kFeaturesVpuTopologyMask);
  EXPECT_EQ(full.get(hw::kWidthsVoxelOffset), 8u | 2u << 8U | 9u << 16U | 22u << 24U);
  EXPECT_EQ(full.get(hw::kWidthsSlbOffset), 8u | 7u << 8U | 7u << 16U | 2u << 24U);
  EXPECT_EQ(full.get(hw::kWidthsTopologyOffset), 4u | 4u << 8U | 20u << 16U | 18u << 24U);
}

TEST_F(Device, FreezesWhatItUsesWhileEnabledOrBusy) {
  EXPECT_EQ(registers.write(hw::kCommandBaseLowOffset, 16), Request::Start);
  registers.write(hw::kControlOffset, hw::kControlEnableMask);
  EXPECT_EQ(registers.write(hw::kCommandBaseLowOffset, 32), Request::None);
  EXPECT_EQ(registers.write(hw::kResultHeadOffset, 1), Request::None);
  EXPECT_EQ(registers.write(hw::kResultTailOffset, 7), Request::Start) << "software's own count";
  EXPECT_EQ(registers.untimely_writes(), 2u);
  registers.set_busy(true);
  registers.write(hw::kControlOffset, 0);
  registers.write(hw::kCommandBaseLowOffset, 64);
  EXPECT_EQ(registers.get(hw::kCommandBaseLowOffset), 16u);
  registers.set_busy(false);
  registers.write(hw::kCommandBaseLowOffset, 64);
  EXPECT_EQ(registers.get(hw::kCommandBaseLowOffset), 64u);
}

TEST_F(Device, OnceStoppedTakesAResetAlone) {
  registers.write(hw::kInterruptEnableOffset, 7);
  registers.stop(hw::kErrorCodeIsTimeout, 5, 0x123456789A);
  registers.stop(hw::kErrorCodeIsBadRing, 6, 1);
  EXPECT_TRUE(registers.interrupt());
  EXPECT_EQ(registers.get(hw::kErrorStatusOffset), hw::kErrorCodeIsTimeout | 5u << 16U) << "the first counts";
  EXPECT_EQ(registers.get_address(hw::kErrorAddressLowOffset), 0x123456789Au);
  registers.write(hw::kControlOffset, hw::kControlEnableMask);
  EXPECT_FALSE(registers.enabled());
  registers.write(hw::kInterruptStatusOffset, hw::kInterruptStatusErrorMask);
  EXPECT_FALSE(registers.interrupt());
  EXPECT_EQ(registers.write(hw::kResetOffset, 1), Request::Reset);
  registers.reset();
  EXPECT_FALSE(registers.stopped());
  EXPECT_EQ(registers.get(hw::kInterruptEnableOffset), 0u);
  EXPECT_EQ(registers.get(hw::kErrorStatusOffset), hw::kErrorCodeIsTimeout | 5u << 16U) << "survives";
  EXPECT_NE(registers.get(hw::kFeaturesOffset), 0u);
}

TEST_F(Device, RefusesOffsetsWithoutARegister) {
  EXPECT_EQ(registers.write(0xFFC, 1), Request::Refused);
  EXPECT_EQ(registers.read(0xFFC), std::nullopt);
}

TEST_F(Device, CountersAreThoseOfTheSnapshot) {
  const auto engine = golden::make_golden_engine(config);
  const std::vector<golden::Word> nops(3, 0);
  engine->submit(nops);
  engine->drain([](auto) {});
  EXPECT_EQ(registers.write(hw::kSnapshotOffset, 1), Request::Snapshot);
  EXPECT_EQ(registers.get(hw::kCounterLowOffset), 0u);
  registers.snapshot(engine->counters());
  EXPECT_EQ(registers.get(hw::kCounterLowOffset), 3u) << "COMMANDS";
  EXPECT_EQ(registers.get(hw::kCounterLowOffset + 16 * hw::kCounterLowStride), 0u)
      << "of a unit that is not there";
}

}  // namespace
}  // namespace gnomon::sim::system::test
