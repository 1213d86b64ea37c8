// SPDX-License-Identifier: Apache-2.0
// Techniques that no hardware runs: plain-map, pcf and raycast (docs/techniques.md).
#pragma once

#include "host/pipeline/technique.hpp"

namespace gnomon::pipeline {

/// Whether `technique` is one of those below.
bool is_software(std::string_view technique);

/// The views must be directional lights'. `kernel`: texels read on each axis.
Result<std::vector<std::unique_ptr<Technique>>> make_maps(const RunSettings& settings,
                                                          std::span<const TechniqueInput> views, int kernel);
/// All views share one tessellation, which the first to be solved builds.
std::vector<std::unique_ptr<Technique>> make_ray_casters(const RunSettings& settings,
                                                         std::span<const TechniqueInput> views);

/// What a technique does between writing nothing and decoding nothing.
class SoftwareTechnique : public Technique {
 public:
  SoftwareTechnique(const TechniqueInput& input, int depth_bits);

  const golden::HardwareConfig& config() const override { return config_; }
  bool answers_points() const override { return true; }
  bool is_software() const override { return true; }
  std::optional<std::vector<golden::VoxelState>> in_double() const override { return std::nullopt; }
  /// Keeps what is to be answered; the commands are none.
  Result<void> write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     std::span<const Receiver> points) override;
  void solve() override;
  Result<Answers> decode(std::span<const golden::Word> results) const override;
  void ask(golden::StreamWriter&, std::span<const Receiver>) const override {}
  Result<std::vector<std::uint8_t>> answers(std::span<const golden::Word> results,
                                            std::span<const Receiver> points,
                                            std::span<const golden::Word> run) const override;
  std::vector<report::PassCycles> cycles() const override { return {}; }
  void describe(const PartAnswers& golden, std::span<const golden::Word> results,
                report::ViewRecord& record) const override;

 protected:
  const TechniqueInput& input() const { return input_; }
  /// Of the light; the run has made it by now.
  const metrics::ExactReference& exact() const { return input_.exact->value(); }
  std::uint64_t asked() const { return asked_; }

  /// What comes before the first answer.
  virtual void build() = 0;
  /// Thread-safe once build() has returned; only asked about points that face the light.
  virtual bool in_shadow(const Receiver& point) const = 0;
  virtual void describe(report::SoftwareRecord& record) const = 0;

 private:
  std::vector<std::uint8_t> answered(std::span<const Receiver> points) const;

  TechniqueInput input_;
  golden::HardwareConfig config_;    ///< no unit at all
  std::vector<Receiver> receivers_;  ///< the voxels' representatives, then the points
  std::vector<std::uint8_t> answers_;
  std::uint64_t asked_ = 0;  ///< receivers that face the light
  double build_seconds_ = 0, seconds_ = 0;
};

}  // namespace gnomon::pipeline
