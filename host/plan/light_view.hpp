// SPDX-License-Identifier: Apache-2.0
// How the hardware sees a light: as one projection, or as several. Theory: docs/planning.md, "Views".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/base/light.hpp"
#include "host/base/light_plane.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// One projection: parallel along `axes.away`, or from `eye` around `axes.away`. Grid coordinates.
struct LightView {
  enum class Kind : std::uint8_t { Directional, Spot, PointSide };

  Kind kind = Kind::Directional;
  LightAxes axes;
  Vec3 eye{0, 0, 0};  ///< the light's place; means nothing for a directional light
  /// Spot: tangent of half the cone's angle. Side of a point light: 1, half the side of its square at
  /// distance
  /// 1. Directional: 0.
  double tangent = 0;
  int half_axis = 0;  ///< side of a point light: 0..5 for +x, -x, +y, -y, +z, -z

  bool perspective() const { return kind != Kind::Directional; }
  /// Whether the answer at p is this view's to give: inside the cone, or on this side of a point light.
  bool answers(const Vec3& p) const;
  /// Whether something at p can shadow a point that this view answers.
  bool can_shadow(const Vec3& p) const;
  /// "directional", "spot", "+x" ...
  std::string name() const;
};

/// The side of a point light that p lies on, 0..5: the axis along which it is farthest from the light, of
/// several the first. A point at the light itself lies on side 0.
int half_axis_of(const Vec3& from_light);

LightView directional_view(const Vec3& travel);

/// All views of a light: one of a directional light and of a spot; of a point light those of its six sides
/// that hold a voxel's representative. `light` in grid coordinates.
std::vector<LightView> light_views(const Light& light, const voxel::VoxelSet& voxels);

/// What a view is about, as numbers of voxels, ascending.
struct ViewVoxels {
  std::vector<std::uint32_t> casters;    ///< what can shadow a receiver
  std::vector<std::uint32_t> receivers;  ///< what is asked about
};

/// Every voxel as both.
ViewVoxels all_voxels(const voxel::VoxelSet& voxels);

/// By object: what may cast a shadow, what is asked whether it lies in one, which surfaces are open.
struct ObjectRoles {
  std::vector<bool> casts, receives, two_sided;

  /// `two_sided` as given; everything casts and receives.
  static ObjectRoles all(std::vector<bool> two_sided);
};

/// The voxels of the objects that cast that can shadow something of the view, and those of the objects that
/// receive whose answer is this view's.
ViewVoxels view_voxels(const LightView& view, const voxel::VoxelSet& voxels, const ObjectRoles& roles);

}  // namespace gnomon::plan
