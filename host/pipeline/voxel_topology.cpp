// SPDX-License-Identifier: Apache-2.0
// Technique voxel-topology: beams against the quads between voxels (docs/vpu-topology.md).
#include "host/pipeline/voxel_topology.hpp"

#include <algorithm>
#include <utility>

#include "host/pipeline/records.hpp"
#include "host/plan/topology_double.hpp"
#include "host/plan/topology_plan.hpp"

namespace gnomon::pipeline {
namespace {

using golden::VoxelState;

class VoxelTopology final : public Technique {
 public:
  VoxelTopology(const TechniqueInput& input, plan::TopologyPlan plan)
      : input_(input), plan_(std::move(plan)), config_(plan_.vpu.config) {
    config_.en_vpu_offset = false;
    if (plan_.settings.order == plan::ItemOrder::Tile)
      sent_ = plan::sent_by_tile(plan_.vpu.projection, input.voxels, input.seen, plan::Objects::Together);
  }

  const golden::HardwareConfig& config() const override { return config_; }
  bool answers_points() const override { return false; }
  double pitch() const override { return plan_.vpu.projection.pitch; }
  double pitch_on_plane() const override { return plan_.vpu.projection.pitch_on_plane(); }

  Result<void> write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     std::span<const Receiver>) override {
    plan::write_topology(writer, hardware, plan_, input_.voxels,
                         sent_ ? sent_->voxels.receivers : input_.seen.receivers, input_.roles.two_sided);
    return {};
  }

  Result<Answers> decode(std::span<const golden::Word> results) const override {
    const auto voxels = plan::topology_results(results, input_.seen.receivers.size());
    if (!voxels) return fail(voxels.error().message);
    Answers answers;
    answers.voxels.reserve(voxels->size());
    for (const golden::topology::TopologyResult& result : *voxels)
      answers.voxels.push_back(result.shadow ? VoxelState::Shadow : VoxelState::Lit);
    if (sent_) answers.voxels = plan::put_back(answers.voxels, sent_->places);
    return answers;
  }

  std::optional<std::vector<VoxelState>> in_double() const override {
    return plan::topology_states_double(plan_, input_.voxels, input_.quads.limit(), input_.seen.receivers,
                                        input_.roles.two_sided)
        .states;
  }

  void describe(const PartAnswers& golden, std::span<const golden::Word>,
                report::ViewRecord& record) const override;

 private:
  TechniqueInput input_;
  plan::TopologyPlan plan_;
  golden::HardwareConfig config_;
  std::optional<plan::SentVoxels> sent_;  ///< nothing where they are sent in their own order
};

void VoxelTopology::describe(const PartAnswers&, std::span<const golden::Word>,
                             report::ViewRecord& record) const {
  record.registers = register_records(plan_.vpu);
  report::TopologyRecord& lists = record.topology.emplace();
  lists.side = static_cast<std::uint32_t>(config_.plane_side());
  lists.pitch = pitch();
  for (const std::uint32_t length : plan_.list_length) {
    lists.lists += length > 0 ? 1U : 0U;
    lists.longest = std::max(lists.longest, length);
  }
}

}  // namespace

Result<std::unique_ptr<Technique>> make_voxel_topology(const RunSettings& settings,
                                                       const TechniqueInput& input) {
  plan::TopologySettings topology = settings.topology;
  topology.order = settings.order;
  auto plan = plan::plan_topology(input.voxels, input.quads.casting(), input.view, input.seen, topology);
  if (!plan) return fail(plan.error().message);
  return std::make_unique<VoxelTopology>(input, std::move(*plan));
}

}  // namespace gnomon::pipeline
