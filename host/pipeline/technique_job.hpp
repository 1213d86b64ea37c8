// SPDX-License-Identifier: Apache-2.0
// One technique over a lit scene: planned, run, compared, measured, drawn.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/metrics/shadow_error.hpp"
#include "host/pipeline/lit_scene.hpp"
#include "host/pipeline/stages.hpp"
#include "host/pipeline/technique.hpp"

namespace gnomon::pipeline {

/// What is drawn for one technique.
struct TechniquePictures {
  render::Picture picture;
  render::Image error;
  std::optional<render::Image> memory;
};

/// Each member function is a stage, or a few that belong together; call them in this order.
class TechniqueJob {
 public:
  /// Both must outlive it.
  TechniqueJob(const RunRequest& request, LitScene& scene, std::string name)
      : request_(request), scene_(scene), name_(std::move(name)), stages_(request, {}) {}

  Result<void> plan();
  /// Needs scene.look().
  Result<void> run();
  void draw();
  /// What the request asks for of a moving camera, as files of `folder`, which is made. Needs run(). Answers
  /// that the hardware keeps are asked for; those that were given already are remembered; no shadow is found
  /// anew.
  Result<void> draw_frames(const std::filesystem::path& folder);
  /// All that is known of the run; `shared` are the stages before and between.
  report::RunRecord record(const std::vector<report::StageTime>& shared) const;

  const std::string& name() const { return name_; }
  const golden::HardwareConfig& hardware() const { return hardware_; }
  const std::vector<golden::Word>& stream() const { return stream_; }
  /// By light, then by voxel.
  const std::vector<std::vector<golden::VoxelState>>& states() const { return states_; }
  const TechniquePictures& pictures() const { return pictures_; }
  const report::CompareRecord& compare() const { return compare_; }
  /// The request's `abort` has ended the engine under test: what is left to do is to say so.
  bool interrupted() const { return !compare_.partial.empty() && stages_.requested(); }

 private:
  struct View {
    std::size_t light = 0, number = 0;  ///< number: among the light's views
    std::unique_ptr<Technique> technique;
  };

  std::vector<Receiver> points_of(std::size_t light) const;
  Result<void> write_stream();
  bool is_software() const { return views_.front().technique->is_software(); }
  void run_software();
  Result<void> run_engines();
  void run_golden();
  Result<std::unique_ptr<sim::RtlEngine>> make_rtl(const sim::RtlOptions& options) const;
  Result<void> run_rtl();
  Result<void> decode();
  metrics::SampleAnswers sample_answers(std::size_t light) const;
  report::ShadowMapRecord measure_shadow_map(std::size_t light, const LightPlane& plane) const;
  std::vector<std::optional<std::vector<golden::VoxelState>>> in_double() const;
  void measure_errors();
  double mean_of(std::size_t light, double (Technique::*figure)() const) const;
  metrics::ErrorOptions error_options(std::size_t light) const;
  bool answers_points() const { return views_.front().technique->answers_points(); }
  render::Picture picture() const;
  bool frames_ask() const;
  Result<std::vector<golden::Word>> ask(std::span<const golden::Word> words);
  Result<render::Picture> picture_of_points(const render::Camera& camera,
                                            const render::PictureOptions& options);
  Result<std::vector<std::vector<golden::VoxelState>>> looked_up(const render::Camera& camera,
                                                                 const render::PictureOptions& options);
  Result<render::Picture> frame(const render::Camera& camera, const render::PictureOptions& options);

  const RunRequest& request_;
  LitScene& scene_;
  std::string name_;
  Stages stages_;
  std::vector<View> views_;  ///< in the order of the stream
  golden::HardwareConfig hardware_;
  std::vector<render::VisiblePoints> visible_;  ///< by light, if the technique answers at points
  std::vector<golden::Word> stream_;
  std::vector<std::size_t> ends_;  ///< of each view's commands in the stream
  EngineAnswers golden_;
  std::vector<std::span<const golden::Word>> parts_;     ///< of golden's results, a view each
  std::vector<std::vector<golden::VoxelState>> states_;  ///< by light
  std::vector<std::vector<std::uint8_t>> points_;        ///< by light
  report::CompareRecord compare_;
  std::vector<report::PassCycles> cycles_;
  std::optional<report::SystemRecord> system_;
  std::vector<report::LightRecord> lights_;
  report::PictureRecord picture_record_;
  std::optional<report::FramesRecord> frames_;
  std::unique_ptr<golden::Engine> engine_;  ///< these two as the run has left them, if frames ask them
  std::unique_ptr<sim::RtlEngine> rtl_;
  TechniquePictures pictures_;
};

}  // namespace gnomon::pipeline
