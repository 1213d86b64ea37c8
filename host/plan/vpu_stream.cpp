// SPDX-License-Identifier: Apache-2.0
// A plan and its voxels as command words, and result words as voxel states (docs/command-stream.md).
#include <fmt/format.h>

#include <algorithm>

#include "host/plan/object_runs.hpp"
#include "host/plan/vpu_plan.hpp"

namespace gnomon::plan {
namespace {

/// A command's worth of items at a time: items take more room than their words.
template <class Write>
void in_parts(std::span<const std::uint32_t> numbers, const VpuPlan& plan, const voxel::VoxelSet& voxels,
              Write write) {
  std::vector<golden::VoxelItem> items;
  for (std::size_t first = 0; first < numbers.size(); first += golden::kMaxItems) {
    const auto part =
        numbers.subspan(first, std::min<std::size_t>(golden::kMaxItems, numbers.size() - first));
    items.clear();
    for (const std::uint32_t i : part) items.push_back(voxel_item(voxels.voxels[i], plan.config));
    write(items);
  }
}

}  // namespace

void write_registers(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     const VpuPlan& plan) {
  std::vector<std::int64_t> registers = plan.registers;
  registers.resize(static_cast<std::size_t>(golden::register_count(hardware)), 0);
  writer.set_registers(golden::Register::MatrixUx, registers);
}

void write_vpu(golden::StreamWriter& writer, const golden::HardwareConfig& hardware, const VpuPlan& plan,
               const voxel::VoxelSet& voxels, const ViewVoxels& seen, const std::vector<bool>& two_sided) {
  write_registers(writer, hardware, plan);
  writer.clear_plane();
  in_parts(seen.casters, plan, voxels, [&](const auto& items) { writer.project(items); });
  for_each_object(seen.receivers, voxels, [&](std::span<const std::uint32_t> numbers, std::uint32_t object) {
    in_parts(numbers, plan, voxels, [&](const auto& items) { writer.resolve(items, two_sided.at(object)); });
  });
}

std::vector<golden::Word> vpu_stream(const VpuPlan& plan, const voxel::VoxelSet& voxels,
                                     const std::vector<bool>& two_sided) {
  golden::StreamWriter writer(plan.config);
  write_vpu(writer, plan.config, plan, voxels, all_voxels(voxels), two_sided);
  writer.fence(0, true);
  return writer.take();
}

Result<std::vector<golden::VoxelResult>> voxel_results(std::span<const golden::Word> results,
                                                       std::size_t expected) {
  std::vector<golden::VoxelResult> voxels;
  voxels.reserve(expected);
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    const golden::Word word = result->word;
    switch (golden::result_code(word)) {
      case golden::ResultCode::VoxelState:
        voxels.push_back(golden::decode_voxel_result(word));
        break;
      case golden::ResultCode::Error:
        return fail("the hardware refused a command: " + golden::describe_result(word));
      case golden::ResultCode::Fence:
      case golden::ResultCode::PlaneEntry:
        break;
    }
  }
  if (voxels.size() != expected)
    return fail(fmt::format("the hardware returned {} voxel states, expected {}", voxels.size(), expected));
  return voxels;
}

}  // namespace gnomon::plan
