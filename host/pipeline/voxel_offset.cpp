// SPDX-License-Identifier: Apache-2.0
// Technique voxel-offset: the projection unit alone, in offset mode (docs/vpu.md).
#include "host/pipeline/voxel_offset.hpp"

#include <utility>

#include "host/pipeline/records.hpp"
#include "host/plan/item_order.hpp"
#include "host/plan/vpu_plan.hpp"

namespace gnomon::pipeline {
namespace {

class VoxelOffset final : public Technique {
 public:
  VoxelOffset(const TechniqueInput& input, plan::VpuPlan plan, plan::ItemOrder order)
      : input_(input), plan_(std::move(plan)) {
    if (order == plan::ItemOrder::Tile)
      sent_ = plan::sent_by_tile(plan_.projection, input.voxels, input.seen, plan::Objects::Apart);
  }

  const golden::HardwareConfig& config() const override { return plan_.config; }
  bool answers_points() const override { return false; }
  double pitch() const override { return plan_.projection.pitch; }
  double pitch_on_plane() const override { return plan_.projection.pitch_on_plane(); }

  Result<void> write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     std::span<const Receiver>) override {
    plan::write_vpu(writer, hardware, plan_, input_.voxels, sent_ ? sent_->voxels : input_.seen,
                    input_.roles.two_sided);
    return {};
  }

  Result<Answers> decode(std::span<const golden::Word> results) const override {
    const auto voxels = plan::voxel_results(results, input_.seen.receivers.size());
    if (!voxels) return fail(voxels.error().message);
    Answers answers;
    answers.voxels.reserve(voxels->size());
    for (const golden::VoxelResult& result : *voxels) answers.voxels.push_back(result.state);
    if (sent_) answers.voxels = plan::put_back(answers.voxels, sent_->places);
    return answers;
  }

  std::optional<std::vector<golden::VoxelState>> in_double() const override {
    return plan::offset_states_double(plan_, input_.voxels, input_.seen, input_.roles.two_sided);
  }

  void describe(const PartAnswers& golden, std::span<const golden::Word>,
                report::ViewRecord& record) const override {
    record.registers = register_records(plan_);
    record.plane = plane_record(plan_, golden);
  }

 private:
  TechniqueInput input_;
  plan::VpuPlan plan_;
  std::optional<plan::SentVoxels> sent_;  ///< nothing where they are sent in their own order
};

}  // namespace

Result<std::unique_ptr<Technique>> make_voxel_offset(const RunSettings& settings,
                                                     const TechniqueInput& input) {
  auto plan = plan::plan_vpu(input.voxels, input.view, input.seen, settings.vpu);
  if (!plan) return fail(plan.error().message);
  return std::make_unique<VoxelOffset>(input, std::move(*plan), settings.order);
}

}  // namespace gnomon::pipeline
