// SPDX-License-Identifier: Apache-2.0
// Access rules that go beyond a register's own.
#include "sim/system/device_registers.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "sim/counter_names.hpp"
#include "sim/registers/registers.hpp"

namespace gnomon::sim::system {

namespace hw = registers::hardware;

namespace {

// Bases, sizes and the hardware's counts.
constexpr std::array kSetUpOnly{
    hw::kPlaneBaseLowOffset, hw::kPlaneBaseHighOffset, hw::kCommandBaseLowOffset, hw::kCommandBaseHighOffset,
    hw::kCommandSizeOffset,  hw::kCommandTailOffset,   hw::kResultBaseLowOffset,  hw::kResultBaseHighOffset,
    hw::kResultSizeOffset,   hw::kResultHeadOffset};

std::uint32_t bytes_of(int a, int b = 0, int c = 0, int d = 0) {
  return static_cast<std::uint32_t>(a | b << 8 | c << 16 | d << 24);
}

}  // namespace

DeviceRegisters::DeviceRegisters(const golden::HardwareConfig& config)
    : config_(config), file_(hw::kRegisters) {
  describe_build();
}

void DeviceRegisters::describe_build() {
  const golden::HardwareConfig& c = config_;
  std::uint32_t features = hw::kFeaturesRingsMask;
  if (c.en_slb) features |= hw::kFeaturesSlbMask;
  if (c.en_vpu_offset) features |= hw::kFeaturesVpuOffsetMask;
  if (c.en_vpu_topology) features |= hw::kFeaturesVpuTopologyMask;
  if (c.en_perspective) features |= hw::kFeaturesPerspectiveMask;
  if (c.en_frame_buffer) features |= hw::kFeaturesFrameBufferMask;
  set(hw::kFeaturesOffset, features);
  set(hw::kWidthsVoxelOffset, bytes_of(c.voxel_bits, c.voxel_frac_bits, c.normal_bits, c.matrix_frac_bits));
  set(hw::kWidthsPlaneOffset, bytes_of(c.plane_log2, c.depth_bits));
  if (c.en_vpu_topology)
    set(hw::kWidthsTopologyOffset, bytes_of(c.sub_bits, c.span_log2, c.nodes_log2, c.quads_log2));
  if (!c.en_slb) return;
  set(hw::kWidthsSlbOffset, bytes_of(c.slb_plane_log2, c.frac_bits, c.slope_bits, c.frags_per_pixel));
  set(hw::kWidthsPointOffset, bytes_of(c.subpixel_bits, c.query_bits, static_cast<int>(c.slb_rounding)));
}

std::uint64_t DeviceRegisters::get_address(std::uint32_t low_offset) const {
  return get(low_offset) | std::uint64_t{get(low_offset + 4)} << 32U;
}

bool DeviceRegisters::enabled() const {
  return (get(hw::kControlOffset) & hw::kControlEnableMask) != 0;
}
bool DeviceRegisters::stopped() const {
  return (get(hw::kStatusOffset) & hw::kStatusStoppedMask) != 0;
}
bool DeviceRegisters::interrupt() const {
  return (get(hw::kInterruptStatusOffset) & get(hw::kInterruptEnableOffset)) != 0;
}

bool DeviceRegisters::untimely(std::uint32_t offset) const {
  const bool idle = (get(hw::kStatusOffset) & hw::kStatusIdleMask) != 0;
  return (enabled() || !idle) && std::find(kSetUpOnly.begin(), kSetUpOnly.end(), offset) != kSetUpOnly.end();
}

Request DeviceRegisters::write(std::uint32_t offset, std::uint32_t value) {
  if (file_.find(offset) == nullptr) return Request::Refused;
  if (offset == hw::kResetOffset)
    return (value & hw::kResetSoftResetMask) != 0 ? Request::Reset : Request::None;
  if (stopped() && offset != hw::kInterruptStatusOffset) return Request::None;
  if (untimely(offset)) {
    ++untimely_writes_;
    return Request::None;
  }
  file_.write(offset, value);
  if (offset == hw::kSnapshotOffset)
    return (value & hw::kSnapshotTakeMask) != 0 ? Request::Snapshot : Request::None;
  return Request::Start;
}

void DeviceRegisters::set_status(std::uint32_t mask, bool value) {
  const std::uint32_t status = get(hw::kStatusOffset);
  set(hw::kStatusOffset, value ? status | mask : status & ~mask);
}
void DeviceRegisters::set_busy(bool busy) {
  set_status(hw::kStatusIdleMask, !busy);
}
void DeviceRegisters::set_result_blocked(bool blocked) {
  set_status(hw::kStatusResultBlockedMask, blocked);
}

void DeviceRegisters::raise(std::uint32_t bits) {
  set(hw::kInterruptStatusOffset, get(hw::kInterruptStatusOffset) | bits);
}

void DeviceRegisters::stop(std::uint32_t code, std::uint16_t job, std::uint64_t address) {
  if (stopped()) return;
  set(hw::kErrorStatusOffset,
      code << hw::kErrorStatusCodeShift | std::uint32_t{job} << hw::kErrorStatusJobShift);
  set(hw::kErrorAddressLowOffset, static_cast<std::uint32_t>(address));
  set(hw::kErrorAddressHighOffset, static_cast<std::uint32_t>(address >> 32U));
  set_status(hw::kStatusStoppedMask, true);
  raise(hw::kInterruptStatusErrorMask);
}

void DeviceRegisters::reset() {
  constexpr std::array kSurvivors{hw::kErrorStatusOffset, hw::kErrorAddressLowOffset,
                                  hw::kErrorAddressHighOffset};
  std::array<std::uint32_t, kSurvivors.size()> kept{};
  for (std::size_t i = 0; i < kSurvivors.size(); ++i) kept.at(i) = get(kSurvivors.at(i));
  file_.reset();
  describe_build();
  for (std::size_t i = 0; i < kSurvivors.size(); ++i) set(kSurvivors.at(i), kept.at(i));
}

void DeviceRegisters::snapshot(const golden::Counters& counters) {
  const auto copy = [&](std::uint32_t first, auto& names) {
    for (std::uint32_t i = 0; i < names.size(); ++i) {
      const auto found = counters.events.find(std::string(names[i]));
      const std::uint64_t value = found == counters.events.end() ? 0 : found->second;
      set(hw::kCounterLowOffset + (first + i) * hw::kCounterLowStride, static_cast<std::uint32_t>(value));
      set(hw::kCounterHighOffset + (first + i) * hw::kCounterHighStride,
          static_cast<std::uint32_t>(value >> 32U));
    }
  };
  copy(0, kEventNames);
  copy(kFirstSlbCounter, kSlbEventNames);
  copy(kFirstTopologyCounter, kTopologyEventNames);
}

}  // namespace gnomon::sim::system
