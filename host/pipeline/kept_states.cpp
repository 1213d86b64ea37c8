// SPDX-License-Identifier: Apache-2.0
// The same commands, told to keep their states; lookups of all receivers behind them.
#include "host/pipeline/kept_states.hpp"

#include <algorithm>
#include <utility>

#include "host/plan/frame_lookup.hpp"

namespace gnomon::pipeline {
namespace {

class KeptStates final : public Technique {
 public:
  /// `clear`: it is the first view of the run.
  KeptStates(std::unique_ptr<Technique> technique, const TechniqueInput& input,
             const golden::HardwareConfig& config, bool clear)
      : technique_(std::move(technique)), input_(input), config_(config), clear_(clear) {}

  const golden::HardwareConfig& config() const override { return config_; }
  bool answers_points() const override { return false; }
  double pitch() const override { return technique_->pitch(); }
  double pitch_on_plane() const override { return technique_->pitch_on_plane(); }
  std::vector<LightPlane> shadow_maps() const override { return technique_->shadow_maps(); }
  std::optional<std::vector<golden::VoxelState>> in_double() const override {
    return technique_->in_double();
  }

  Result<void> write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     std::span<const Receiver> points) override {
    const auto layer = static_cast<std::uint32_t>(input_.light);
    lookup_.emplace(input_.voxels, input_.seen.receivers, hardware);
    if (clear_) writer.clear_frame();
    writer.keep(golden::Keeping{.layer = layer});
    auto written = technique_->write(writer, hardware, points);
    writer.keep(std::nullopt);
    if (written) lookup_->write(writer, layer);
    return written;
  }

  Result<Answers> decode(std::span<const golden::Word> results) const override {
    const plan::FrameLookup* one[] = {&lookup_.value()};
    auto states = plan::frame_states(results, one);
    if (!states) return fail(states.error().message);
    return Answers{.voxels = std::move(states->front()), .points = {}};
  }

  void describe(const PartAnswers& golden, std::span<const golden::Word> results,
                report::ViewRecord& record) const override {
    technique_->describe(golden, results, record);
  }

 private:
  std::unique_ptr<Technique> technique_;
  TechniqueInput input_;
  golden::HardwareConfig config_;
  bool clear_;
  std::optional<plan::FrameLookup> lookup_;  ///< of all receivers, once written
};

}  // namespace

Result<std::vector<std::unique_ptr<Technique>>> keep_states(
    std::vector<std::unique_ptr<Technique>> techniques, std::span<const TechniqueInput> views) {
  std::size_t lights = 0;
  for (const TechniqueInput& view : views) lights = std::max(lights, view.light + 1);
  for (std::size_t i = 0; i < techniques.size(); ++i) {
    if (techniques[i]->config().en_slb)
      return fail(
          "frame_buffer=on keeps states of voxels, which technique=slb and slb+voxel do not answer by");
    auto config = plan::with_frame_buffer(techniques[i]->config(), lights);
    if (!config) return fail(config.error().message);
    techniques[i] = std::make_unique<KeptStates>(std::move(techniques[i]), views[i], *config, i == 0);
  }
  return techniques;
}

}  // namespace gnomon::pipeline
