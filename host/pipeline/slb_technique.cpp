// SPDX-License-Identifier: Apache-2.0
// Outlines, samples and receivers go in; answers come out, one for each receiver that faces the light.
#include "host/pipeline/slb_technique.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <gnomon/golden/slb/codec.hpp>
#include <gnomon/golden/stream.hpp>
#include <utility>

#include "host/metrics/voxel_index.hpp"
#include "host/outline/outline.hpp"
#include "host/pipeline/records.hpp"
#include "host/pipeline/slb_answers.hpp"
#include "host/plan/slb_stream.hpp"
#include "host/plan/vpu_plan.hpp"
#include "host/slb/buffer_picture.hpp"

namespace gnomon::pipeline {
namespace {

using golden::VoxelState;

constexpr int kLargestDump = 1024;  // pixels a side
constexpr int kPicturePixels = 24;  // a side, of the plane's part that is shown

/// One hardware with both units.
golden::HardwareConfig joined(const golden::HardwareConfig& vpu, golden::HardwareConfig slb) {
  slb.voxel_bits = vpu.voxel_bits;
  slb.voxel_frac_bits = vpu.voxel_frac_bits;
  slb.normal_bits = vpu.normal_bits;
  slb.matrix_frac_bits = vpu.matrix_frac_bits;
  slb.plane_log2 = vpu.plane_log2;
  slb.en_vpu_offset = true;
  return slb;
}

/// The plane as READ_ENTRIES gave it, row-major.
std::vector<golden::slb::Entry> entries_of(std::span<const golden::Word> results,
                                           const golden::slb::SlbConfig& config) {
  std::vector<golden::slb::Entry> entries;
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    if (!result->raw.empty())
      entries.push_back(golden::slb::unpack_entry({result->raw.begin(), result->raw.end()}, config));
  }
  return entries;
}

class SlbTechnique final : public Technique {
 public:
  SlbTechnique(const TechniqueInput& input, plan::SlbPlan slb, std::optional<plan::VpuPlan> vpu,
               plan::ItemOrder order)
      : input_(input), slb_(std::move(slb)), vpu_(std::move(vpu)), config_(slb_.config), order_(order) {
    if (!vpu_) return;
    config_ = joined(vpu_->config, slb_.config);
    if (order == plan::ItemOrder::Tile)
      sent_ = plan::sent_by_tile(vpu_->projection, input.voxels, input.seen, plan::Objects::Apart);
  }

  const golden::HardwareConfig& config() const override { return config_; }
  bool answers_points() const override { return true; }
  double pitch() const override { return slb_.plane.pitch; }
  std::optional<std::vector<VoxelState>> in_double() const override { return std::nullopt; }

  Result<void> write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                     std::span<const Receiver> points) override;
  Result<Answers> decode(std::span<const golden::Word> results) const override;
  void ask(golden::StreamWriter& writer, std::span<const Receiver> points) const override {
    plan::ask_receivers(writer, slb_, points, plan::asking_order(slb_, points, order_));
  }
  Result<std::vector<std::uint8_t>> answers(std::span<const golden::Word> results,
                                            std::span<const Receiver> points,
                                            std::span<const golden::Word> run) const override;
  std::vector<LightPlane> shadow_maps() const override {
    return {slb_.plane, slb_.plane.finer(1 << config_.frac_bits)};
  }
  void describe(const PartAnswers& golden, std::span<const golden::Word> results,
                report::ViewRecord& record) const override;
  std::optional<render::Image> memory_picture(std::span<const golden::Word> results) const override;

 private:
  /// The whole plane is read back and compared, unless it is so large that this would take longer than all
  /// the rest.
  bool is_dumped() const { return slb_.plane.side <= kLargestDump; }
  std::uint32_t pixels() const {
    return static_cast<std::uint32_t>(slb_.plane.side) * static_cast<std::uint32_t>(slb_.plane.side);
  }
  Result<void> draw(golden::StreamWriter& writer) const;
  Result<std::vector<VoxelState>> states_of_voxels(std::span<const golden::Word> results) const;
  Result<std::vector<std::uint8_t>> shadowed(std::span<const golden::Word> results,
                                             std::span<const Receiver> receivers,
                                             std::span<const std::uint32_t> places,
                                             std::span<const VoxelState> states, std::size_t voxels) const;
  VoxelState state_near(const metrics::VoxelIndex& index, std::span<const VoxelState> states,
                        const Vec3& point) const;

  TechniqueInput input_;
  plan::SlbPlan slb_;
  std::optional<plan::VpuPlan> vpu_;
  golden::HardwareConfig config_;
  plan::ItemOrder order_;
  std::optional<plan::SentVoxels> sent_;  ///< to the projection unit; nothing where in their own order
  std::vector<Receiver> receivers_;       ///< the voxels' representatives, then the points
  std::vector<std::uint32_t> places_;     ///< in which order they are asked about
};

Result<void> SlbTechnique::draw(golden::StreamWriter& writer) const {
  std::vector<outline::ObjectOutline> outlines;
  std::vector<std::vector<golden::slb::CoverSample>> sheets;
  outline::Options options;
  options.frac_bits = config_.frac_bits;
  for (std::uint32_t object = 0; object < input_.surfaces.size(); ++object) {
    if (!slb_.casts[object]) continue;
    auto outline = outline::outlines(input_.surfaces.subspan(object, 1), slb_.frame(), options);
    if (!outline) return fail(outline.error().message);
    outline->front().object = object;
    outlines.push_back(std::move(outline->front()));
    sheets.push_back(
        plan::cover_samples(slb_, plan::sheet_samples(slb_, input_.surfaces[object], input_.voxels, object,
                                                      input_.roles.two_sided[object])));
  }
  plan::draw_casters(writer, slb_, outlines, sheets);
  return {};
}

Result<void> SlbTechnique::write(golden::StreamWriter& writer, const golden::HardwareConfig& hardware,
                                 std::span<const Receiver> points) {
  if (vpu_)
    plan::write_vpu(writer, hardware, *vpu_, input_.voxels, sent_ ? sent_->voxels : input_.seen,
                    input_.roles.two_sided);
  receivers_ = voxel_receivers(input_.surfaces, input_.voxels, input_.roles, input_.view, input_.seen);
  receivers_.insert(receivers_.end(), points.begin(), points.end());
  if (auto done = draw(writer); !done) return fail(done.error().message);
  places_ = plan::asking_order(slb_, receivers_, order_);
  plan::ask_receivers(writer, slb_, receivers_, places_);
  if (is_dumped()) writer.read_entries(0, pixels());
  return {};
}

/// Of the receivers, as the projection unit found them; none without it.
Result<std::vector<VoxelState>> SlbTechnique::states_of_voxels(std::span<const golden::Word> results) const {
  if (!vpu_) return std::vector<VoxelState>();
  const auto voxels = plan::voxel_results(results, input_.seen.receivers.size());
  if (!voxels) return fail(voxels.error().message);
  std::vector<VoxelState> states;
  states.reserve(voxels->size());
  for (const golden::VoxelResult& result : *voxels) states.push_back(result.state);
  if (sent_) states = plan::put_back(std::move(states), sent_->places);
  return states;
}

/// The state that a point's voxel has; lit where it has none or was not asked about.
VoxelState SlbTechnique::state_near(const metrics::VoxelIndex& index, std::span<const VoxelState> states,
                                    const Vec3& point) const {
  const std::uint32_t voxel = index.answering(point);
  const std::vector<std::uint32_t>& asked = input_.seen.receivers;
  const auto found = std::ranges::lower_bound(asked, voxel);
  if (found == asked.end() || *found != voxel) return VoxelState::Lit;
  return states[static_cast<std::size_t>(found - asked.begin())];
}

/// 1 for shadow, one a receiver; they were asked about in the order of `places`. The first `voxels` of them
/// are the voxels asked about, which `states` belongs to.
Result<std::vector<std::uint8_t>> SlbTechnique::shadowed(std::span<const golden::Word> results,
                                                         std::span<const Receiver> receivers,
                                                         std::span<const std::uint32_t> places,
                                                         std::span<const VoxelState> states,
                                                         std::size_t voxels) const {
  const auto answers = query_answers(results, receivers.size());
  if (!answers) return fail(answers.error().message);
  const metrics::VoxelIndex index(input_.voxels);
  std::vector<std::uint8_t> shadowed(receivers.size(), 1);
  std::size_t next = 0;
  for (std::size_t asked = 0; asked < receivers.size(); ++asked) {
    const std::size_t i = places.empty() ? asked : places[asked];
    const Receiver& r = receivers[i];
    if (!r.faces_light()) continue;
    if (next == answers->size()) return fail("the hardware answered fewer queries than it was asked");
    const golden::slb::QueryAnswer& answer = (*answers)[next++];
    shadowed[i] = answer.shadow ? 1 : 0;
    if (states.empty() || answer.has_fragment) continue;
    const auto state = i < voxels ? states[i] : state_near(index, states, Vec3(r.x, r.y, r.z));
    shadowed[i] = state == VoxelState::Shadow ? 1 : 0;
  }
  if (next != answers->size()) return fail("the hardware answered more queries than it was asked");
  return shadowed;
}

Result<Answers> SlbTechnique::decode(std::span<const golden::Word> results) const {
  const auto states = states_of_voxels(results);
  if (!states) return fail(states.error().message);
  const std::size_t voxels = input_.seen.receivers.size();
  const auto answered = shadowed(results, receivers_, places_, *states, voxels);
  if (!answered) return fail(answered.error().message);
  Answers all;
  const auto first_point = answered->begin() + static_cast<std::ptrdiff_t>(voxels);
  for (auto at = answered->begin(); at != first_point; ++at)
    all.voxels.push_back(*at != 0 ? VoxelState::Shadow : VoxelState::Lit);
  all.points.assign(first_point, answered->end());
  return all;
}

Result<std::vector<std::uint8_t>> SlbTechnique::answers(std::span<const golden::Word> results,
                                                        std::span<const Receiver> points,
                                                        std::span<const golden::Word> run) const {
  const auto states = states_of_voxels(run);
  if (!states) return fail(states.error().message);
  return shadowed(results, points, plan::asking_order(slb_, points, order_), *states, 0);
}

void SlbTechnique::describe(const PartAnswers& golden, std::span<const golden::Word> results,
                            report::ViewRecord& record) const {
  if (vpu_) {
    record.registers = register_records(*vpu_);
    record.plane = plane_record(*vpu_, golden);
  }
  const golden::slb::SlbConfig slb = config_.slb_config();
  report::SlbRecord& use = record.slb.emplace(slb_record(slb_, config_));
  for (const golden::slb::Entry& entry : entries_of(results, slb)) {
    ++use.pixels_by_fragments.at(entry.count);
    use.full_pixels += entry.full_depth != slb.no_depth() ? 1U : 0U;
    use.overflow_pixels += entry.overflow ? 1U : 0U;
  }
}

std::optional<render::Image> SlbTechnique::memory_picture(std::span<const golden::Word> results) const {
  if (!is_dumped()) return std::nullopt;
  const golden::slb::SlbConfig config = config_.slb_config();
  const std::vector<golden::slb::Entry> entries = entries_of(results, config);
  const slb::Window window = slb::busiest_window(entries, config, kPicturePixels);
  return slb::buffer_picture(entries, config, window, slb::BufferPictureOptions{});
}

}  // namespace

Result<std::unique_ptr<Technique>> make_slb(const RunSettings& settings, const TechniqueInput& input) {
  auto slb = plan::plan_slb(input.voxels, input.roles.casts, input.view.axes.away, settings.slb);
  if (!slb) return fail(slb.error().message);
  return std::make_unique<SlbTechnique>(input, std::move(*slb), std::nullopt, settings.order);
}

Result<std::unique_ptr<Technique>> make_slb_with_voxels(const RunSettings& settings,
                                                        const TechniqueInput& input) {
  auto slb = plan::plan_slb(input.voxels, input.roles.casts, input.view.axes.away, settings.slb);
  if (!slb) return fail(slb.error().message);
  plan::VpuSettings vpu_settings = settings.vpu;
  vpu_settings.plane_log2 = 0;  // `plane` is the SLB's here
  auto vpu = plan::plan_vpu(input.voxels, input.view, input.seen, vpu_settings);
  if (!vpu) return fail(vpu.error().message);
  return std::make_unique<SlbTechnique>(input, std::move(*slb), std::move(*vpu), settings.order);
}

}  // namespace gnomon::pipeline
