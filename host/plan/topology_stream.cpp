// SPDX-License-Identifier: Apache-2.0
// A topology plan as command words, and result words as answers (docs/vpu-topology.md, "Commands").
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host/plan/object_runs.hpp"
#include "host/plan/topology_plan.hpp"

namespace gnomon::plan {

namespace topology = golden::topology;

namespace {

void put_quads(golden::StreamWriter& writer, const TopologyPlan& plan) {
  // A command's worth at a time: corners take more room than their numbers.
  constexpr std::size_t kPart = golden::kMaxItems / topology::kWordsPerQuad;
  std::vector<std::array<golden::VoxelItem, 4>> corners;
  const std::span<const voxel::VoxelQuad> quads = plan.quads;
  for (std::size_t first = 0; first < quads.size(); first += kPart) {
    corners.clear();
    for (const voxel::VoxelQuad& q : quads.subspan(first, std::min(kPart, quads.size() - first)))
      corners.push_back({plan.items[q[0]], plan.items[q[1]], plan.items[q[2]], plan.items[q[3]]});
    writer.put_quads(corners);
  }
}

}  // namespace

void write_topology(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                    const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                    std::span<const std::uint32_t> receivers, const std::vector<bool>& two_sided) {
  write_registers(writer, hardware, plan.vpu);
  writer.clear_lists();
  put_quads(writer, plan);
  std::vector<golden::VoxelItem> items;
  for_each_object(receivers, voxels, [&](std::span<const std::uint32_t> numbers, std::uint32_t object) {
    items.clear();
    for (const std::uint32_t i : numbers) items.push_back(plan.items[i]);
    writer.resolve_topology(items, two_sided.at(object), plan.clearance, plan.settings.sorted);
  });
}

std::vector<golden::Word> topology_stream(const TopologyPlan& plan, const voxel::VoxelSet& voxels,
                                          const std::vector<bool>& two_sided) {
  golden::StreamWriter writer(plan.vpu.config);
  write_topology(writer, plan.vpu.config, plan, voxels, all_voxels(voxels).receivers, two_sided);
  writer.fence(0, true);
  return writer.take();
}

Result<std::vector<topology::TopologyResult>> topology_results(std::span<const golden::Word> results,
                                                               std::size_t expected) {
  constexpr int kCode = 56;
  std::vector<topology::TopologyResult> voxels;
  voxels.reserve(expected);
  for (const auto word : results) {
    if (golden::result_code(word) == golden::ResultCode::Error)
      return fail("the hardware refused a command: " + golden::describe_result(word));
    if (word >> kCode == topology::kStateCode) voxels.push_back(topology::decode_topology_result(word));
  }
  if (voxels.size() != expected)
    return fail(fmt::format("the hardware returned {} voxel states, expected {}", voxels.size(), expected));
  return voxels;
}

}  // namespace gnomon::plan
