// SPDX-License-Identifier: Apache-2.0
// Made by sim/registers/generate from registers.toml; do not edit.

#pragma once
#include <array>
#include <cstdint>

#include "sim/registers/register_info.hpp"

namespace gnomon::sim::registers {
/// The hardware.
namespace hardware {
inline constexpr std::uint32_t kBase = 0x10000000;
inline constexpr std::uint32_t kIdOffset = 0x0;
inline constexpr std::uint32_t kIdReset = 0x4D4F4E47;
inline constexpr std::uint32_t kVersionOffset = 0x4;
inline constexpr std::uint32_t kVersionReset = 0x10001;
inline constexpr std::uint32_t kVersionMinorShift = 0x0;
inline constexpr std::uint32_t kVersionMinorMask = 0xFFFF;
inline constexpr std::uint32_t kVersionMajorShift = 0x10;
inline constexpr std::uint32_t kVersionMajorMask = 0xFFFF0000;
inline constexpr std::uint32_t kFeaturesOffset = 0x8;
inline constexpr std::uint32_t kFeaturesSlbShift = 0x0;
inline constexpr std::uint32_t kFeaturesSlbMask = 0x1;
inline constexpr std::uint32_t kFeaturesVpuOffsetShift = 0x1;
inline constexpr std::uint32_t kFeaturesVpuOffsetMask = 0x2;
inline constexpr std::uint32_t kFeaturesVpuTopologyShift = 0x2;
inline constexpr std::uint32_t kFeaturesVpuTopologyMask = 0x4;
inline constexpr std::uint32_t kFeaturesPerspectiveShift = 0x3;
inline constexpr std::uint32_t kFeaturesPerspectiveMask = 0x8;
inline constexpr std::uint32_t kFeaturesFrameBufferShift = 0x4;
inline constexpr std::uint32_t kFeaturesFrameBufferMask = 0x10;
inline constexpr std::uint32_t kFeaturesCacheShift = 0x10;
inline constexpr std::uint32_t kFeaturesCacheMask = 0x10000;
inline constexpr std::uint32_t kFeaturesStreamPortsShift = 0x11;
inline constexpr std::uint32_t kFeaturesStreamPortsMask = 0x20000;
inline constexpr std::uint32_t kFeaturesRingsShift = 0x12;
inline constexpr std::uint32_t kFeaturesRingsMask = 0x40000;
inline constexpr std::uint32_t kWidthsVoxelOffset = 0x10;
inline constexpr std::uint32_t kWidthsVoxelVoxelBitsShift = 0x0;
inline constexpr std::uint32_t kWidthsVoxelVoxelBitsMask = 0xFF;
inline constexpr std::uint32_t kWidthsVoxelVoxelFracBitsShift = 0x8;
inline constexpr std::uint32_t kWidthsVoxelVoxelFracBitsMask = 0xFF00;
inline constexpr std::uint32_t kWidthsVoxelNormalBitsShift = 0x10;
inline constexpr std::uint32_t kWidthsVoxelNormalBitsMask = 0xFF0000;
inline constexpr std::uint32_t kWidthsVoxelMatrixFracBitsShift = 0x18;
inline constexpr std::uint32_t kWidthsVoxelMatrixFracBitsMask = 0xFF000000;
inline constexpr std::uint32_t kWidthsPlaneOffset = 0x14;
inline constexpr std::uint32_t kWidthsPlanePlaneLog2Shift = 0x0;
inline constexpr std::uint32_t kWidthsPlanePlaneLog2Mask = 0xFF;
inline constexpr std::uint32_t kWidthsPlaneDepthBitsShift = 0x8;
inline constexpr std::uint32_t kWidthsPlaneDepthBitsMask = 0xFF00;
inline constexpr std::uint32_t kWidthsTopologyOffset = 0x18;
inline constexpr std::uint32_t kWidthsTopologySubBitsShift = 0x0;
inline constexpr std::uint32_t kWidthsTopologySubBitsMask = 0xFF;
inline constexpr std::uint32_t kWidthsTopologySpanLog2Shift = 0x8;
inline constexpr std::uint32_t kWidthsTopologySpanLog2Mask = 0xFF00;
inline constexpr std::uint32_t kWidthsTopologyNodesLog2Shift = 0x10;
inline constexpr std::uint32_t kWidthsTopologyNodesLog2Mask = 0xFF0000;
inline constexpr std::uint32_t kWidthsTopologyQuadsLog2Shift = 0x18;
inline constexpr std::uint32_t kWidthsTopologyQuadsLog2Mask = 0xFF000000;
inline constexpr std::uint32_t kWidthsSlbOffset = 0x1C;
inline constexpr std::uint32_t kWidthsSlbSlbPlaneLog2Shift = 0x0;
inline constexpr std::uint32_t kWidthsSlbSlbPlaneLog2Mask = 0xFF;
inline constexpr std::uint32_t kWidthsSlbFracBitsShift = 0x8;
inline constexpr std::uint32_t kWidthsSlbFracBitsMask = 0xFF00;
inline constexpr std::uint32_t kWidthsSlbSlopeBitsShift = 0x10;
inline constexpr std::uint32_t kWidthsSlbSlopeBitsMask = 0xFF0000;
inline constexpr std::uint32_t kWidthsSlbFragsPerPixelShift = 0x18;
inline constexpr std::uint32_t kWidthsSlbFragsPerPixelMask = 0xFF000000;
inline constexpr std::uint32_t kWidthsPointOffset = 0x20;
inline constexpr std::uint32_t kWidthsPointSubpixelBitsShift = 0x0;
inline constexpr std::uint32_t kWidthsPointSubpixelBitsMask = 0xFF;
inline constexpr std::uint32_t kWidthsPointQueryBitsShift = 0x8;
inline constexpr std::uint32_t kWidthsPointQueryBitsMask = 0xFF00;
inline constexpr std::uint32_t kWidthsPointSlbRoundingShift = 0x10;
inline constexpr std::uint32_t kWidthsPointSlbRoundingMask = 0xFF0000;
inline constexpr std::uint32_t kWidthsMemoryOffset = 0x24;
inline constexpr std::uint32_t kWidthsMemoryAxiBytesLog2Shift = 0x0;
inline constexpr std::uint32_t kWidthsMemoryAxiBytesLog2Mask = 0xFF;
inline constexpr std::uint32_t kWidthsMemoryCacheLog2Shift = 0x8;
inline constexpr std::uint32_t kWidthsMemoryCacheLog2Mask = 0xFF00;
inline constexpr std::uint32_t kWidthsMemoryLineIdsLog2Shift = 0x10;
inline constexpr std::uint32_t kWidthsMemoryLineIdsLog2Mask = 0xFF0000;
inline constexpr std::uint32_t kControlOffset = 0x40;
inline constexpr std::uint32_t kControlReset = 0x0;
inline constexpr std::uint32_t kControlEnableShift = 0x0;
inline constexpr std::uint32_t kControlEnableMask = 0x1;
inline constexpr std::uint32_t kControlSourceShift = 0x1;
inline constexpr std::uint32_t kControlSourceMask = 0x2;
inline constexpr std::uint32_t kResetOffset = 0x44;
inline constexpr std::uint32_t kResetReset = 0x0;
inline constexpr std::uint32_t kResetSoftResetShift = 0x0;
inline constexpr std::uint32_t kResetSoftResetMask = 0x1;
inline constexpr std::uint32_t kStatusOffset = 0x48;
inline constexpr std::uint32_t kStatusReset = 0x1;
inline constexpr std::uint32_t kStatusIdleShift = 0x0;
inline constexpr std::uint32_t kStatusIdleMask = 0x1;
inline constexpr std::uint32_t kStatusResultBlockedShift = 0x1;
inline constexpr std::uint32_t kStatusResultBlockedMask = 0x2;
inline constexpr std::uint32_t kStatusStoppedShift = 0x2;
inline constexpr std::uint32_t kStatusStoppedMask = 0x4;
inline constexpr std::uint32_t kStatusLateShift = 0x3;
inline constexpr std::uint32_t kStatusLateMask = 0x8;
inline constexpr std::uint32_t kAxiTimeoutOffset = 0x4C;
inline constexpr std::uint32_t kAxiTimeoutReset = 0x10000;
inline constexpr std::uint32_t kPlaneBaseLowOffset = 0x50;
inline constexpr std::uint32_t kPlaneBaseLowReset = 0x0;
inline constexpr std::uint32_t kPlaneBaseHighOffset = 0x54;
inline constexpr std::uint32_t kPlaneBaseHighReset = 0x0;
inline constexpr std::uint32_t kCommandBaseLowOffset = 0x60;
inline constexpr std::uint32_t kCommandBaseLowReset = 0x0;
inline constexpr std::uint32_t kCommandBaseHighOffset = 0x64;
inline constexpr std::uint32_t kCommandBaseHighReset = 0x0;
inline constexpr std::uint32_t kCommandSizeOffset = 0x68;
inline constexpr std::uint32_t kCommandSizeReset = 0x0;
inline constexpr std::uint32_t kCommandSizeLog2Shift = 0x0;
inline constexpr std::uint32_t kCommandSizeLog2Mask = 0x1F;
inline constexpr std::uint32_t kCommandHeadOffset = 0x6C;
inline constexpr std::uint32_t kCommandHeadReset = 0x0;
inline constexpr std::uint32_t kCommandTailOffset = 0x70;
inline constexpr std::uint32_t kCommandTailReset = 0x0;
inline constexpr std::uint32_t kResultBaseLowOffset = 0x80;
inline constexpr std::uint32_t kResultBaseLowReset = 0x0;
inline constexpr std::uint32_t kResultBaseHighOffset = 0x84;
inline constexpr std::uint32_t kResultBaseHighReset = 0x0;
inline constexpr std::uint32_t kResultSizeOffset = 0x88;
inline constexpr std::uint32_t kResultSizeReset = 0x0;
inline constexpr std::uint32_t kResultSizeLog2Shift = 0x0;
inline constexpr std::uint32_t kResultSizeLog2Mask = 0x1F;
inline constexpr std::uint32_t kResultHeadOffset = 0x8C;
inline constexpr std::uint32_t kResultHeadReset = 0x0;
inline constexpr std::uint32_t kResultTailOffset = 0x90;
inline constexpr std::uint32_t kResultTailReset = 0x0;
inline constexpr std::uint32_t kInterruptStatusOffset = 0xA0;
inline constexpr std::uint32_t kInterruptStatusReset = 0x0;
inline constexpr std::uint32_t kInterruptStatusJobDoneShift = 0x0;
inline constexpr std::uint32_t kInterruptStatusJobDoneMask = 0x1;
inline constexpr std::uint32_t kInterruptStatusResultFullShift = 0x1;
inline constexpr std::uint32_t kInterruptStatusResultFullMask = 0x2;
inline constexpr std::uint32_t kInterruptStatusErrorShift = 0x2;
inline constexpr std::uint32_t kInterruptStatusErrorMask = 0x4;
inline constexpr std::uint32_t kInterruptEnableOffset = 0xA4;
inline constexpr std::uint32_t kInterruptEnableReset = 0x0;
inline constexpr std::uint32_t kInterruptEnableJobDoneShift = 0x0;
inline constexpr std::uint32_t kInterruptEnableJobDoneMask = 0x1;
inline constexpr std::uint32_t kInterruptEnableResultFullShift = 0x1;
inline constexpr std::uint32_t kInterruptEnableResultFullMask = 0x2;
inline constexpr std::uint32_t kInterruptEnableErrorShift = 0x2;
inline constexpr std::uint32_t kInterruptEnableErrorMask = 0x4;
inline constexpr std::uint32_t kErrorStatusOffset = 0xC0;
inline constexpr std::uint32_t kErrorStatusReset = 0x0;
inline constexpr std::uint32_t kErrorStatusCodeShift = 0x0;
inline constexpr std::uint32_t kErrorStatusCodeMask = 0xFF;
inline constexpr std::uint32_t kErrorStatusJobShift = 0x10;
inline constexpr std::uint32_t kErrorStatusJobMask = 0xFFFF0000;
inline constexpr std::uint32_t kErrorAddressLowOffset = 0xC4;
inline constexpr std::uint32_t kErrorAddressLowReset = 0x0;
inline constexpr std::uint32_t kErrorAddressHighOffset = 0xC8;
inline constexpr std::uint32_t kErrorAddressHighReset = 0x0;
inline constexpr std::uint32_t kJobsDoneOffset = 0xD0;
inline constexpr std::uint32_t kJobsDoneReset = 0x0;
inline constexpr std::uint32_t kJobFlagsOffset = 0xD4;
inline constexpr std::uint32_t kJobFlagsReset = 0x0;
inline constexpr std::uint32_t kJobFlagsFlagsShift = 0x0;
inline constexpr std::uint32_t kJobFlagsFlagsMask = 0xFFFFFF;
inline constexpr std::uint32_t kSnapshotOffset = 0xE0;
inline constexpr std::uint32_t kSnapshotReset = 0x0;
inline constexpr std::uint32_t kSnapshotTakeShift = 0x0;
inline constexpr std::uint32_t kSnapshotTakeMask = 0x1;
inline constexpr std::uint32_t kCounterLowOffset = 0x400;
inline constexpr std::uint32_t kCounterLowCount = 0x100;
inline constexpr std::uint32_t kCounterLowStride = 0x8;
inline constexpr std::uint32_t kCounterLowReset = 0x0;
inline constexpr std::uint32_t kCounterHighOffset = 0x404;
inline constexpr std::uint32_t kCounterHighCount = 0x100;
inline constexpr std::uint32_t kCounterHighStride = 0x8;
inline constexpr std::uint32_t kCounterHighReset = 0x0;
inline constexpr std::uint32_t kErrorCodeIsNone = 0x0;
inline constexpr std::uint32_t kErrorCodeIsReadSlverr = 0x1;
inline constexpr std::uint32_t kErrorCodeIsReadDecerr = 0x2;
inline constexpr std::uint32_t kErrorCodeIsWriteSlverr = 0x3;
inline constexpr std::uint32_t kErrorCodeIsWriteDecerr = 0x4;
inline constexpr std::uint32_t kErrorCodeIsTimeout = 0x5;
inline constexpr std::uint32_t kErrorCodeIsBadDescriptor = 0x6;
inline constexpr std::uint32_t kErrorCodeIsBadRing = 0x7;
inline constexpr std::uint32_t kErrorCodeIsCutCommand = 0x8;
inline constexpr std::array<RegisterInfo, 35> kRegisters{{
    {"ID", 0x0, 1, 4, Access::Ro, 0x4D4F4E47, 0xFFFFFFFF},
    {"VERSION", 0x4, 1, 4, Access::Ro, 0x10001, 0xFFFFFFFF},
    {"FEATURES", 0x8, 1, 4, Access::Ro, 0x0, 0x7001F},
    {"WIDTHS_VOXEL", 0x10, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"WIDTHS_PLANE", 0x14, 1, 4, Access::Ro, 0x0, 0xFFFF},
    {"WIDTHS_TOPOLOGY", 0x18, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"WIDTHS_SLB", 0x1C, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"WIDTHS_POINT", 0x20, 1, 4, Access::Ro, 0x0, 0xFFFFFF},
    {"WIDTHS_MEMORY", 0x24, 1, 4, Access::Ro, 0x0, 0xFFFFFF},
    {"CONTROL", 0x40, 1, 4, Access::Rw, 0x0, 0x3},
    {"RESET", 0x44, 1, 4, Access::W1p, 0x0, 0x1},
    {"STATUS", 0x48, 1, 4, Access::Ro, 0x1, 0xF},
    {"AXI_TIMEOUT", 0x4C, 1, 4, Access::Rw, 0x10000, 0xFFFFFFFF},
    {"PLANE_BASE_LOW", 0x50, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"PLANE_BASE_HIGH", 0x54, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"COMMAND_BASE_LOW", 0x60, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"COMMAND_BASE_HIGH", 0x64, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"COMMAND_SIZE", 0x68, 1, 4, Access::Rw, 0x0, 0x1F},
    {"COMMAND_HEAD", 0x6C, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"COMMAND_TAIL", 0x70, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULT_BASE_LOW", 0x80, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULT_BASE_HIGH", 0x84, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULT_SIZE", 0x88, 1, 4, Access::Rw, 0x0, 0x1F},
    {"RESULT_HEAD", 0x8C, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULT_TAIL", 0x90, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"INTERRUPT_STATUS", 0xA0, 1, 4, Access::W1c, 0x0, 0x7},
    {"INTERRUPT_ENABLE", 0xA4, 1, 4, Access::Rw, 0x0, 0x7},
    {"ERROR_STATUS", 0xC0, 1, 4, Access::Ro, 0x0, 0xFFFF00FF},
    {"ERROR_ADDRESS_LOW", 0xC4, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"ERROR_ADDRESS_HIGH", 0xC8, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"JOBS_DONE", 0xD0, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"JOB_FLAGS", 0xD4, 1, 4, Access::Ro, 0x0, 0xFFFFFF},
    {"SNAPSHOT", 0xE0, 1, 4, Access::W1p, 0x0, 0x1},
    {"COUNTER_LOW", 0x400, 256, 8, Access::Ro, 0x0, 0xFFFFFFFF},
    {"COUNTER_HIGH", 0x404, 256, 8, Access::Ro, 0x0, 0xFFFFFFFF},
}};
}  // namespace hardware
/// The mailbox.
namespace mailbox {
inline constexpr std::uint32_t kBase = 0x10010000;
inline constexpr std::uint32_t kCommandRingOffset = 0x0;
inline constexpr std::uint32_t kCommandRingReset = 0x0;
inline constexpr std::uint32_t kCommandRingLog2Offset = 0x4;
inline constexpr std::uint32_t kCommandRingLog2Reset = 0x0;
inline constexpr std::uint32_t kResultRingOffset = 0x8;
inline constexpr std::uint32_t kResultRingReset = 0x0;
inline constexpr std::uint32_t kResultRingLog2Offset = 0xC;
inline constexpr std::uint32_t kResultRingLog2Reset = 0x0;
inline constexpr std::uint32_t kJobTableOffset = 0x10;
inline constexpr std::uint32_t kJobTableReset = 0x0;
inline constexpr std::uint32_t kJobTableLog2Offset = 0x14;
inline constexpr std::uint32_t kJobTableLog2Reset = 0x0;
inline constexpr std::uint32_t kJobsPostedOffset = 0x18;
inline constexpr std::uint32_t kJobsPostedReset = 0x0;
inline constexpr std::uint32_t kResultsTakenOffset = 0x1C;
inline constexpr std::uint32_t kResultsTakenReset = 0x0;
inline constexpr std::uint32_t kPlanesOffset = 0x20;
inline constexpr std::uint32_t kPlanesReset = 0x0;
inline constexpr std::uint32_t kDoorbellOffset = 0x24;
inline constexpr std::uint32_t kDoorbellReset = 0x0;
inline constexpr std::uint32_t kDoorbellRungShift = 0x0;
inline constexpr std::uint32_t kDoorbellRungMask = 0x1;
inline constexpr std::uint32_t kStateOffset = 0x40;
inline constexpr std::uint32_t kStateReset = 0x0;
inline constexpr std::uint32_t kJobsFinishedOffset = 0x44;
inline constexpr std::uint32_t kJobsFinishedReset = 0x0;
inline constexpr std::uint32_t kResultsReadyOffset = 0x48;
inline constexpr std::uint32_t kResultsReadyReset = 0x0;
inline constexpr std::uint32_t kLogOffset = 0x4C;
inline constexpr std::uint32_t kLogReset = 0x0;
inline constexpr std::uint32_t kFailureOffset = 0x50;
inline constexpr std::uint32_t kFailureReset = 0x0;
inline constexpr std::uint32_t kStateIsBooting = 0x0;
inline constexpr std::uint32_t kStateIsReady = 0x1;
inline constexpr std::uint32_t kStateIsWorking = 0x2;
inline constexpr std::uint32_t kStateIsFailed = 0x3;
inline constexpr std::uint32_t kFailureIsNone = 0x0;
inline constexpr std::uint32_t kFailureIsNoHardware = 0x1;
inline constexpr std::uint32_t kFailureIsWrongVersion = 0x2;
inline constexpr std::uint32_t kFailureIsNoRings = 0x3;
inline constexpr std::uint32_t kFailureIsBadMailbox = 0x4;
inline constexpr std::uint32_t kFailureIsNoReset = 0x5;
inline constexpr std::uint32_t kFailureIsTrap = 0x6;
inline constexpr std::uint32_t kOutcomeIsNone = 0x0;
inline constexpr std::uint32_t kOutcomeIsDone = 0x1;
inline constexpr std::uint32_t kOutcomeIsFallback = 0x2;
inline constexpr std::uint32_t kOutcomeIsFailed = 0x3;
inline constexpr std::uint32_t kOutcomeIsRefused = 0x4;
inline constexpr std::array<RegisterInfo, 15> kRegisters{{
    {"COMMAND_RING", 0x0, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"COMMAND_RING_LOG2", 0x4, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULT_RING", 0x8, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULT_RING_LOG2", 0xC, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"JOB_TABLE", 0x10, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"JOB_TABLE_LOG2", 0x14, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"JOBS_POSTED", 0x18, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULTS_TAKEN", 0x1C, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"PLANES", 0x20, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"DOORBELL", 0x24, 1, 4, Access::W1c, 0x0, 0x1},
    {"STATE", 0x40, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"JOBS_FINISHED", 0x44, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"RESULTS_READY", 0x48, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"LOG", 0x4C, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
    {"FAILURE", 0x50, 1, 4, Access::Rw, 0x0, 0xFFFFFFFF},
}};
}  // namespace mailbox
/// The timer.
namespace timer {
inline constexpr std::uint32_t kBase = 0x10020000;
inline constexpr std::uint32_t kTimeLowOffset = 0x0;
inline constexpr std::uint32_t kTimeLowReset = 0x0;
inline constexpr std::uint32_t kTimeHighOffset = 0x4;
inline constexpr std::uint32_t kTimeHighReset = 0x0;
inline constexpr std::uint32_t kCompareLowOffset = 0x8;
inline constexpr std::uint32_t kCompareLowReset = 0xFFFFFFFF;
inline constexpr std::uint32_t kCompareHighOffset = 0xC;
inline constexpr std::uint32_t kCompareHighReset = 0xFFFFFFFF;
inline constexpr std::array<RegisterInfo, 4> kRegisters{{
    {"TIME_LOW", 0x0, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"TIME_HIGH", 0x4, 1, 4, Access::Ro, 0x0, 0xFFFFFFFF},
    {"COMPARE_LOW", 0x8, 1, 4, Access::Rw, 0xFFFFFFFF, 0xFFFFFFFF},
    {"COMPARE_HIGH", 0xC, 1, 4, Access::Rw, 0xFFFFFFFF, 0xFFFFFFFF},
}};
}  // namespace timer
}  // namespace gnomon::sim::registers
