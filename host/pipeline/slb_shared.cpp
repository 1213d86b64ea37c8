// SPDX-License-Identifier: Apache-2.0
// Outlines, sheets, questions and shadow maps, each made for the first configuration that wants it.
#include "host/pipeline/slb_shared.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <gnomon/golden/stream.hpp>
#include <utility>

#include "host/metrics/shadow_map.hpp"
#include "host/pipeline/records.hpp"
#include "host/pipeline/slb_answers.hpp"
#include "host/plan/slb_stream.hpp"

namespace gnomon::pipeline {
namespace {

std::array<int, 4> key_of(const plan::SlbPlan& plan) {
  return {plan.plane.side, plan.config.depth_bits, plan.config.frac_bits, 0};
}

std::vector<Receiver> selected(std::span<const Receiver> receivers, std::span<const std::uint32_t> which) {
  std::vector<Receiver> some;
  some.reserve(which.size());
  for (const std::uint32_t i : which) some.push_back(receivers[i]);
  return some;
}

}  // namespace

Result<std::unique_ptr<SlbShared>> SlbShared::make(const LitScene& scene) {
  if (!knows(scene)) throw std::invalid_argument("one directional light expected");
  std::unique_ptr<SlbShared> shared(new SlbShared(scene));
  auto extent =
      plan::slb_extent(scene.voxels, scene.roles.casts, scene.lights.front().views.front().axes.away);
  if (!extent) return tl::make_unexpected(extent.error());
  shared->extent_ = std::move(*extent);
  return shared;
}

SlbShared::SlbShared(const LitScene& scene) : scene_(scene) {
  const SceneLight& light = scene.lights.front();
  voxels_ =
      voxel_receivers(scene.surfaces, scene.voxels, scene.roles, light.views.front(), light.seen.front());
  for (const auto* samples : {&light.truth.samples, &light.truth.border_samples})
    for (const metrics::SurfaceSample& s : *samples) samples_.push_back({s.x, s.y, s.z, s.facing});
}

Result<plan::SlbPlan> SlbShared::plan(const plan::SlbSettings& settings) const {
  return plan::plan_slb(extent_, settings);
}

template <class T>
void SlbShared::keep(Kept<T>& kept, const Key& key, std::shared_ptr<const T> value) {
  if (kept.order.size() == kDrawings) {
    kept.made.erase(kept.order.front());
    kept.order.erase(kept.order.begin());
  }
  kept.made.emplace(key, std::move(value));
  kept.order.push_back(key);
}

Result<std::shared_ptr<const SlbDrawing>> SlbShared::drawing(const plan::SlbPlan& plan) {
  const std::scoped_lock lock(drawing_mutex_);
  const Key key = key_of(plan);
  if (const auto found = drawings_.made.find(key); found != drawings_.made.end()) return found->second;
  auto drawn = draw(plan);
  if (!drawn) return tl::make_unexpected(drawn.error());
  auto made = std::make_shared<const SlbDrawing>(std::move(*drawn));
  keep(drawings_, key, made);
  return made;
}

Result<SlbDrawing> SlbShared::draw(const plan::SlbPlan& plan) const {
  SlbDrawing drawing;
  outline::Options options;
  options.frac_bits = plan.config.frac_bits;
  for (std::uint32_t object = 0; object < scene_.surfaces.size(); ++object) {
    if (!plan.casts[object]) continue;
    const std::span surfaces(scene_.surfaces);
    auto outline = outline::outlines(surfaces.subspan(object, 1), plan.frame(), options);
    if (!outline) return tl::make_unexpected(outline.error());
    outline->front().object = object;
    drawing.outlines.push_back(std::move(outline->front()));
    drawing.sheets.push_back(plan::cover_samples(
        plan,
        plan::sheet_samples(plan, surfaces[object], scene_.voxels, object, scene_.roles.two_sided[object])));
  }
  const SlbTouched touched(drawing.outlines, plan.plane.side);
  if (auto done = answer_far(plan, touched, drawing); !done) return tl::make_unexpected(done.error());
  return drawing;
}

/// By a configuration of its own, so that the answers do not depend on who asks first.
Result<void> SlbShared::answer_far(const plan::SlbPlan& plan, const SlbTouched& touched,
                                   SlbDrawing& drawing) const {
  plan::SlbPlan own = plan;
  plan::SlbSettings settings;
  settings.frac_bits = settings.slope_bits = plan.config.frac_bits;
  settings.depth_bits = plan.config.depth_bits;
  settings.frags = golden::slb::kMaxFragments;
  own.config = settings.hardware(plan.config.slb_plane_log2);
  if (const auto wrong = own.config.check()) return fail(*wrong);
  drawing.answers.assign(samples_.size(), 1);  // those that face away
  std::vector<std::uint32_t> far;
  for (std::uint32_t i = 0; i < samples_.size(); ++i) {
    const Receiver& r = samples_[i];
    if (!r.faces_light()) continue;
    const bool sees_line = touched.crowded() || touched.at(plan.plane.pixel(Vec3(r.x, r.y, r.z)));
    (sees_line ? drawing.near : far).push_back(i);
  }
  golden::StreamWriter writer(own.config);
  plan::draw_casters(writer, own, drawing.outlines, drawing.sheets);
  plan::ask_receivers(writer, own, selected(samples_, far));
  const auto engine = golden::make_golden_engine(own.config);
  std::vector<golden::Word> results;
  engine->submit(writer.words());
  engine->drain([&](std::span<const golden::Word> words) {
    results.insert(results.end(), words.begin(), words.end());
  });
  const auto answers = query_answers(results, far.size());
  if (!answers) return tl::make_unexpected(answers.error());
  for (std::size_t i = 0; i < far.size(); ++i) drawing.answers[far[i]] = answers->at(i).shadow ? 1 : 0;
  return {};
}

std::shared_ptr<const SlbQuestions> SlbShared::questions(const plan::SlbPlan& plan, const SlbDrawing& drawing,
                                                         plan::ItemOrder order) {
  const std::scoped_lock lock(question_mutex_);
  Key key = key_of(plan);
  key.back() = 2 * plan.config.query_bits + static_cast<int>(order);
  if (const auto found = questions_.made.find(key); found != questions_.made.end()) return found->second;
  const auto commands = [&](std::span<const Receiver> receivers, std::span<const std::uint32_t> places) {
    golden::StreamWriter writer(plan.config);
    plan::ask_receivers(writer, plan, receivers, places);
    return writer.take();
  };
  std::vector<std::uint32_t> places = plan::asking_order(plan, voxels_, order);
  auto of_voxels = commands(voxels_, places);
  auto made = std::make_shared<const SlbQuestions>(
      SlbQuestions{std::move(of_voxels), std::move(places), commands(selected(samples_, drawing.near), {})});
  keep(questions_, key, made);
  return made;
}

report::ShadowMapRecord SlbShared::shadow_map(const plan::SlbPlan& plan, int finer,
                                              const metrics::ErrorOptions& options) {
  const std::scoped_lock lock(map_mutex_);
  const Key key{plan.plane.side, plan.config.depth_bits, finer, 0};
  if (const auto found = maps_.made.find(key); found != maps_.made.end()) return *found->second;
  const SceneLight& light = scene_.lights.front();
  const LightPlane plane = plan.plane.finer(finer);
  const metrics::ShadowMap map(*light.exact, plane);
  auto made = std::make_shared<const report::ShadowMapRecord>(
      shadow_map_record(light.truth, scene_.voxels, map.states(scene_.voxels, scene_.roles.two_sided),
                        map.answers(light.truth), plane, plan.config.depth_bits, options));
  keep(maps_, key, made);
  return *made;
}

}  // namespace gnomon::pipeline
