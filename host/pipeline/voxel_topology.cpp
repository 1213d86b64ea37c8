// SPDX-License-Identifier: Apache-2.0
// Technique voxel-topology: beams against the quads between voxels (docs/vpu-topology.md).
#include "host/pipeline/voxel_topology.hpp"

#include <algorithm>
#include <utility>

#include "host/pipeline/records.hpp"
#include "host/plan/topology_double.hpp"
#include "host/plan/topology_plan.hpp"
#include "host/voxel/subpatches.hpp"

namespace gnomon::pipeline {
namespace {

using golden::VoxelState;

class VoxelTopology final : public Technique {
 public:
  VoxelTopology(const TechniqueInput& input, plan::TopologyPlan plan)
      : input_(input), plan_(std::move(plan)), config_(plan_.vpu.config) {
    config_.en_vpu_offset = false;
  }

  const golden::HardwareConfig& config() const override { return config_; }
  bool answers_points() const override { return false; }
  double pitch() const override { return plan_.vpu.projection.pitch; }

  Result<std::vector<golden::Word>> stream(std::span<const Receiver>) override {
    return plan::topology_stream(plan_, input_.voxels, input_.two_sided);
  }

  Result<Answers> decode(std::span<const golden::Word> results) const override {
    const auto voxels = plan::topology_results(results, input_.voxels.voxels.size());
    if (!voxels) return fail(voxels.error().message);
    Answers answers;
    answers.voxels.reserve(voxels->size());
    for (const golden::topology::TopologyResult& result : *voxels)
      answers.voxels.push_back(result.shadow ? VoxelState::Shadow : VoxelState::Lit);
    return answers;
  }

  std::optional<std::vector<VoxelState>> in_double() const override {
    const auto quads = voxel::limit_quads(input_.surfaces, input_.voxels);
    return plan::topology_states_double(plan_, input_.voxels, quads,
                                        plan::all_voxels(input_.voxels).receivers, input_.two_sided)
        .states;
  }

  void describe(const EngineAnswers& golden, report::RunRecord& record) const override;

 private:
  TechniqueInput input_;
  plan::TopologyPlan plan_;
  golden::HardwareConfig config_;
};

void VoxelTopology::describe(const EngineAnswers&, report::RunRecord& record) const {
  record.registers = register_records(plan_.vpu);
  const auto side = static_cast<std::uint32_t>(config_.plane_side());
  report::TopologyRecord& lists = record.topology.emplace();
  lists.side = side;
  lists.pitch = pitch();
  for (const std::uint32_t length : plan_.list_length) {
    lists.lists += length > 0 ? 1U : 0U;
    lists.longest = std::max(lists.longest, length);
  }
  // docs/vpu-topology.md, "Memory".
  const auto d = static_cast<std::uint64_t>(config_.depth_bits);
  const auto nodes = static_cast<std::uint64_t>(config_.nodes_log2);
  const auto quads = static_cast<std::uint64_t>(config_.quads_log2);
  lists.head_bits = 10 + d + nodes;
  lists.node_bits = (std::uint64_t{1} << nodes) * (1 + nodes + d + quads);
  lists.record_bits =
      (std::uint64_t{1} << quads) *
      static_cast<std::uint64_t>(2 * config_.span_log2 + 8 * (config_.span_log2 + config_.sub_bits));
}

}  // namespace

Result<std::unique_ptr<Technique>> make_voxel_topology(const RunSettings& settings,
                                                       const TechniqueInput& input) {
  const voxel::CastingQuads quads = voxel::casting_quads(input.surfaces, input.voxels);
  auto plan = plan::plan_topology(input.voxels, quads.quads, input.light, settings.topology);
  if (!plan) return fail(plan.error().message);
  return std::make_unique<VoxelTopology>(input, std::move(*plan));
}

}  // namespace gnomon::pipeline
