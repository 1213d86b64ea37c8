// SPDX-License-Identifier: Apache-2.0
// Techniques plain-map and pcf: a depth map over what the silhouette-line buffer's plane covers.
#include <fmt/format.h>

#include <optional>
#include <utility>

#include "host/compare/depth_map.hpp"
#include "host/pipeline/records.hpp"
#include "host/pipeline/software_technique.hpp"
#include "host/plan/slb_plan.hpp"

namespace gnomon::pipeline {
namespace {

class MapTechnique final : public SoftwareTechnique {
 public:
  MapTechnique(const TechniqueInput& input, const compare::MapPlan& plan, std::vector<bool> casts, int kernel)
      : SoftwareTechnique(input, plan.depth_bits), plan_(plan), casts_(std::move(casts)), kernel_(kernel) {}

  double pitch() const override { return plan_.plane.pitch; }
  std::vector<report::PassCycles> cycles() const override {
    const compare::MapCosts costs = map_->costs(asked(), kernel_);
    return {{"CLEAR", {{"BUSY", costs.clear_cycles}}},
            {"DRAW", {{"BUSY", costs.draw_cycles}}},
            {"QUERY", {{"BUSY", costs.query_cycles}}}};
  }

 protected:
  void build() override {
    map_.emplace(plan_, [this](const Vec3& start) {
      const auto met = exact().sheets(start, plan_.plane.axes.away, casts_);
      return compare::Sheets{met.nearest, met.count};
    });
  }
  bool in_shadow(const Receiver& p) const override {
    return map_->in_shadow(Vec3(p.x, p.y, p.z), double{p.facing}, kernel_);
  }
  void describe(report::SoftwareRecord& record) const override {
    const compare::MapCosts costs = map_->costs(asked(), kernel_);
    record.side = static_cast<std::uint32_t>(plan_.plane.side);
    record.pitch = plan_.plane.pitch;
    record.texel_bits = 8 * plan_.texel_bytes();
    record.kernel = static_cast<std::uint32_t>(kernel_);
    record.memory_bits = plan_.memory_bits();
    record.drawn = map_->drawn();
    record.bytes_read = costs.bytes_read;
    record.bytes_written = costs.bytes_written;
  }

 private:
  compare::MapPlan plan_;
  std::vector<bool> casts_;
  int kernel_;
  std::optional<compare::DepthMap> map_;
};

/// What a map of this view may spend, by the hardware that it is compared with.
Result<std::uint64_t> memory_of(const std::string& technique, const RunSettings& settings,
                                const TechniqueInput& view) {
  auto hardware = make_techniques(technique, settings, std::span(&view, 1));
  if (!hardware) return fail(hardware.error().message);
  return hardware_memory_bits(hardware->front()->config());
}

Result<std::unique_ptr<Technique>> make_map(const RunSettings& settings, const TechniqueInput& view,
                                            int kernel) {
  const auto slb = plan::plan_slb(view.voxels, view.roles.casts, view.view.axes.away, settings.slb);
  if (!slb) return fail(slb.error().message);
  compare::MapPlan plan{slb->plane, slb->nearest, slb->codes_per_voxel, slb->config.depth_bits};
  int side = settings.maps.side;
  if (side == 0) {
    const auto bits = memory_of(settings.maps.memory, settings, view);
    if (!bits) return fail(bits.error().message);
    side = compare::side_within(*bits, plan.texel_bytes());
  }
  return std::make_unique<MapTechnique>(view, compare::with_side(plan, side), slb->casts, kernel);
}

}  // namespace

Result<std::vector<std::unique_ptr<Technique>>> make_maps(const RunSettings& settings,
                                                          std::span<const TechniqueInput> views, int kernel) {
  RunSettings without_frame = settings;
  without_frame.frame_buffer = false;
  std::vector<std::unique_ptr<Technique>> all;
  for (const TechniqueInput& view : views) {
    auto made = make_map(without_frame, view, kernel);
    if (!made) return fail(made.error().message);
    all.push_back(std::move(*made));
  }
  return all;
}

}  // namespace gnomon::pipeline
