// SPDX-License-Identifier: Apache-2.0
// Technique raycast: a ray from each point to the light.
#include <algorithm>
#include <memory>
#include <utility>

#include "host/metrics/voxel_index.hpp"
#include "host/pipeline/software_technique.hpp"

namespace gnomon::pipeline {
namespace {

/// The tessellation that all views cast their rays against.
struct SharedRays {
  double sag = 0;
  std::optional<metrics::ExactReference> first;  ///< under the light of the view that built it

  metrics::ExactReference under(const TechniqueInput& input) {
    if (!first) {
      metrics::TessellationOptions options;
      options.sag = sag;
      first.emplace(input.surfaces,
                    metrics::ReferenceObjects{input.roles.two_sided, input.roles.casts, input.roles.receives},
                    input.exact->value().light(), options);
    }
    return first->relit(input.exact->value().light());
  }
};

class RayTechnique final : public SoftwareTechnique {
 public:
  RayTechnique(const TechniqueInput& input, std::shared_ptr<SharedRays> shared)
      : SoftwareTechnique(input, golden::HardwareConfig{}.depth_bits),
        shared_(std::move(shared)),
        distance_(mean_distance()) {}

  /// It has no plane: the unit is the voxel, at the receivers' mean distance where the light has a place.
  double pitch() const override { return 1; }
  double pitch_on_plane() const override { return 1 / distance_; }

 protected:
  void build() override { rays_.emplace(shared_->under(input())); }
  bool in_shadow(const Receiver& r) const override {
    const Vec3 p(r.x, r.y, r.z);
    if (!light_reaches(rays_->light(), p)) return true;
    // As high above the surface as the exact reference starts, along the ray: normals are not known here.
    const double along = std::min(kFarthestStart, rays_->lift() / double{r.facing});
    return rays_->blocked(p + rays_->to_light(p) * along);
  }
  void describe(report::SoftwareRecord& record) const override {
    record.memory_bits = 8 * rays_->memory_bytes();
    record.triangles = rays_->triangles();
  }

 private:
  static constexpr double kFarthestStart = 0.25;  ///< voxels

  double mean_distance() const {
    const plan::LightView& view = input().view;
    if (!view.perspective() || input().seen.receivers.empty()) return 1;
    double sum = 0;
    for (const std::uint32_t v : input().seen.receivers)
      sum += (metrics::representative(input().voxels.voxels[v]) - view.eye).dot(view.axes.away);
    return sum / static_cast<double>(input().seen.receivers.size());
  }

  std::shared_ptr<SharedRays> shared_;
  double distance_;
  std::optional<metrics::ExactReference> rays_;
};

}  // namespace

std::vector<std::unique_ptr<Technique>> make_ray_casters(const RunSettings& settings,
                                                         std::span<const TechniqueInput> views) {
  const auto shared = std::make_shared<SharedRays>();
  shared->sag = settings.ray_sag;
  std::vector<std::unique_ptr<Technique>> all;
  for (const TechniqueInput& view : views) all.push_back(std::make_unique<RayTechnique>(view, shared));
  return all;
}

}  // namespace gnomon::pipeline
