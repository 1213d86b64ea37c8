// SPDX-License-Identifier: Apache-2.0
// What all techniques of a run share: surfaces, voxels, lights, and what is known exactly of their shadows.
#pragma once

#include <optional>
#include <vector>

#include "host/base/light.hpp"
#include "host/metrics/exact_reference.hpp"
#include "host/metrics/shadow_truth.hpp"
#include "host/pipeline/run.hpp"
#include "host/pipeline/scene_quads.hpp"
#include "host/pipeline/stages.hpp"
#include "host/plan/light_view.hpp"
#include "host/render/picture.hpp"
#include "host/surface/limit_surface.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::pipeline {

/// A light in grid coordinates. `seen` runs as `views`; views that would ask about nothing are left out.
struct SceneLight {
  Light light;
  std::vector<plan::LightView> views;
  std::vector<plan::ViewVoxels> seen;
  std::optional<metrics::ExactReference> exact;
  metrics::ShadowTruth truth;
};

/// Neither copied nor moved: its parts refer to each other.
class LitScene {
 public:
  LitScene() = default;
  LitScene(const LitScene&) = delete;
  LitScene& operator=(const LitScene&) = delete;

  /// Surfaces, voxels and views.
  Result<void> build(const RunRequest& request, Stages& stages);
  /// Exact shadows and what pictures are made from.
  void look(const RunRequest& request, Stages& stages);

  std::optional<std::uint32_t> ground() const { return ground_; }
  render::PictureOptions picture_options(const Stages& stages, std::string_view stage) const;

  std::vector<surface::LimitSurface> surfaces;
  plan::ObjectRoles roles;
  voxel::VoxelSet voxels;
  std::optional<SceneQuads> quads;
  std::vector<SceneLight> lights;
  std::optional<render::PictureScene> picture_scene;
  render::Camera camera;  ///< grid coordinates
  std::vector<render::Material> materials;
  render::Picture reference;  ///< with exact shadows

 private:
  Result<void> build_surfaces(const RunRequest& request);
  Result<void> voxelize(const RunRequest& request, const Stages& stages);
  Result<void> see(const RunRequest& request);
  void take_truth(const Stages& stages);

  voxel::Grid grid_;
  std::optional<std::uint32_t> ground_;
  int image_width_ = 0, image_height_ = 0;
};

}  // namespace gnomon::pipeline
