// SPDX-License-Identifier: Apache-2.0
// What configurations of the silhouette-line buffer over one lit scene have in common, made once for all of
// them. Theory: docs/sweep.md, "Shared work".
#pragma once

#include <array>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "host/base/receiver.hpp"
#include "host/base/result.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/outline/outline.hpp"
#include "host/pipeline/lit_scene.hpp"
#include "host/pipeline/slb_touched.hpp"
#include "host/plan/item_order.hpp"
#include "host/plan/slb_plan.hpp"
#include "host/report/run_record.hpp"

namespace gnomon::pipeline {

/// What is drawn on a plane of one size with one depth's width and one F, before anything is rounded to a
/// configuration's widths, and what all of these configurations answer alike.
struct SlbDrawing {
  std::vector<outline::ObjectOutline> outlines;               ///< of the casters
  std::vector<std::vector<golden::slb::CoverSample>> sheets;  ///< of the casters
  std::vector<std::uint8_t> answers;  ///< by sample, 1 for shadow; of those in `near`, nothing yet
  std::vector<std::uint32_t> near;    ///< samples that face the light and may see a line, ascending
};

/// Commands that ask, once all is drawn.
struct SlbQuestions {
  std::vector<golden::Word> voxels;   ///< about all voxels that face the light
  std::vector<std::uint32_t> places;  ///< ... in which order (plan::asking_order)
  std::vector<golden::Word> samples;  ///< about the drawing's near samples
};

/// A scene with one directional light. Thread-safe. Samples are the truth's, then its border samples.
class SlbShared {
 public:
  /// `scene`, which has been looked at, must outlive it. Fails where nothing casts a shadow.
  static Result<std::unique_ptr<SlbShared>> make(const LitScene& scene);

  /// True for scenes that make() takes: one light, a directional one.
  static bool knows(const LitScene& scene) {
    return scene.lights.size() == 1 && std::holds_alternative<DirectionalLight>(scene.lights.front().light) &&
           scene.lights.front().views.size() == 1;
  }

  /// Fails where the settings make no legal hardware.
  Result<plan::SlbPlan> plan(const plan::SlbSettings& settings) const;
  /// The voxels that the light's view asks about, at their representatives.
  std::span<const Receiver> voxels() const { return voxels_; }
  std::span<const Receiver> samples() const { return samples_; }
  const LitScene& scene() const { return scene_; }

  /// For `plan`; made for the first who asks. The last kDrawings are kept.
  Result<std::shared_ptr<const SlbDrawing>> drawing(const plan::SlbPlan& plan);
  std::shared_ptr<const SlbQuestions> questions(const plan::SlbPlan& plan, const SlbDrawing& drawing,
                                                plan::ItemOrder order);
  /// A plain shadow map over the plane, `finer` times as fine a side, as errors_record wants it.
  report::ShadowMapRecord shadow_map(const plan::SlbPlan& plan, int finer,
                                     const metrics::ErrorOptions& options);

  static constexpr std::size_t kDrawings = 32;

 private:
  explicit SlbShared(const LitScene& scene);
  Result<SlbDrawing> draw(const plan::SlbPlan& plan) const;
  Result<void> answer_far(const plan::SlbPlan& plan, const SlbTouched& touched, SlbDrawing& drawing) const;

  /// What outlines and answers depend on: plane, depth bits, F; questions: on query bits and order besides.
  using Key = std::array<int, 4>;
  template <class T>
  struct Kept {
    std::map<Key, std::shared_ptr<const T>> made;
    std::vector<Key> order;  ///< oldest first
  };
  template <class T>
  static void keep(Kept<T>& kept, const Key& key, std::shared_ptr<const T> value);

  const LitScene& scene_;
  plan::SlbExtent extent_;
  std::vector<Receiver> voxels_, samples_;
  std::mutex drawing_mutex_, question_mutex_, map_mutex_;
  Kept<SlbDrawing> drawings_;
  Kept<SlbQuestions> questions_;
  Kept<report::ShadowMapRecord> maps_;
};

}  // namespace gnomon::pipeline
