// SPDX-License-Identifier: Apache-2.0
// A plan and its voxels as command words, and result words as voxel states (docs/command-stream.md).
#include <fmt/format.h>

#include <gnomon/golden/stream.hpp>

#include "host/plan/vpu_plan.hpp"

namespace gnomon::plan {

std::vector<golden::Word> vpu_stream(const VpuPlan& plan, const voxel::VoxelSet& voxels,
                                     std::span<const golden::VoxelItem> items,
                                     const std::vector<bool>& two_sided) {
  golden::StreamWriter writer(plan.config);
  writer.set_registers(golden::Register::MatrixUx, plan.registers);
  writer.clear_plane();
  writer.project(items);
  // Voxels are sorted by object, so each object is one run.
  for (std::size_t first = 0; first < items.size();) {
    const auto object = voxels.voxels[first].object;
    std::size_t end = first;
    while (end < items.size() && voxels.voxels[end].object == object) ++end;
    writer.resolve(items.subspan(first, end - first), two_sided.at(object));
    first = end;
  }
  writer.fence(0, true);
  return writer.words();
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
