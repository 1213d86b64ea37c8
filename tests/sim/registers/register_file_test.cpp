// SPDX-License-Identifier: Apache-2.0
// What software and hardware read and write.
#include "sim/registers/register_file.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/registers/registers.hpp"

namespace gnomon::sim::registers::test {
namespace {

TEST(RegisterFile, HoldsResetValues) {
  const RegisterFile file(hardware::kRegisters);
  EXPECT_EQ(file.read(hardware::kIdOffset), 0x4D4F4E47u);
  EXPECT_EQ(file.read(hardware::kAxiTimeoutOffset), 65536u);
  EXPECT_EQ(file.read(hardware::kStatusOffset), hardware::kStatusIdleMask);
  EXPECT_EQ(RegisterFile(timer::kRegisters).read(timer::kCompareHighOffset), 0xFFFFFFFFu);
}

TEST(RegisterFile, SoftwareChangesWhatItMay) {
  RegisterFile file(hardware::kRegisters);
  EXPECT_TRUE(file.write(hardware::kIdOffset, 0));
  EXPECT_EQ(file.read(hardware::kIdOffset), hardware::kIdReset);
  EXPECT_TRUE(file.write(hardware::kControlOffset, 0xFFFFFFFF));
  EXPECT_EQ(file.read(hardware::kControlOffset), 3u) << "bits that exist";
  EXPECT_TRUE(file.write(hardware::kResetOffset, 1));
  EXPECT_EQ(file.read(hardware::kResetOffset), 0u) << "what it starts is the device's business";
}

TEST(RegisterFile, ClearsWhereOnesAreWritten) {
  RegisterFile file(hardware::kRegisters);
  file.set(hardware::kInterruptStatusOffset, 7);
  EXPECT_TRUE(file.write(hardware::kInterruptStatusOffset, 2));
  EXPECT_EQ(file.read(hardware::kInterruptStatusOffset), 5u);
}

TEST(RegisterFile, KnowsWhereNothingIs) {
  RegisterFile file(hardware::kRegisters);
  for (const std::uint32_t offset : {0x00Cu, 0x3FCu, 0xC00u, 0xFFCu, 0x1000u, 0xFFFFFFFCu}) {
    EXPECT_EQ(file.read(offset), std::nullopt) << offset;
    EXPECT_FALSE(file.write(offset, 1)) << offset;
    EXPECT_THROW(file.set(offset, 1), std::out_of_range);
    EXPECT_THROW(static_cast<void>(file.get(offset)), std::out_of_range);
  }
}

TEST(RegisterFile, KeepsArraysApart) {
  RegisterFile file(hardware::kRegisters);
  for (std::uint32_t i = 0; i < hardware::kCounterLowCount; ++i) {
    file.set(hardware::kCounterLowOffset + i * hardware::kCounterLowStride, i);
    file.set(hardware::kCounterHighOffset + i * hardware::kCounterHighStride, ~i);
  }
  for (std::uint32_t i = 0; i < hardware::kCounterLowCount; ++i) {
    EXPECT_EQ(file.read(0x400 + 8 * i), i);
    EXPECT_EQ(file.read(0x404 + 8 * i), ~i);
  }
  file.reset();
  EXPECT_EQ(file.get(0x400 + 8 * 100), 0u);
}

}  // namespace
}  // namespace gnomon::sim::registers::test
