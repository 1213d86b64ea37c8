// SPDX-License-Identifier: Apache-2.0
// Where the silhouette-line buffer's plane lies for one directional light. Theory: docs/planning.md.
#pragma once

#include <gnomon/golden/config.hpp>
#include <span>
#include <vector>

#include "host/base/light_plane.hpp"
#include "host/base/result.hpp"
#include "host/outline/outline.hpp"
#include "host/plan/slb_settings.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// Everything the SLB needs for one directional light.
struct SlbPlan {
  golden::HardwareConfig config;  ///< with the SLB and without the offset test; the projection unit's
                                  ///< parameters are at their defaults
  LightPlane plane;
  double codes_per_voxel = 1;
  double nearest = 0;       ///< voxels along `away`: the depth of code 0
  std::vector<bool> casts;  ///< by object: false where nothing can be in its shadow

  /// Depth code, not rounded.
  double code(const Vec3& p) const { return (plane.axes.away.dot(p) - nearest) * codes_per_voxel; }
  /// The same for the outliner.
  outline::LightFrame frame() const;
};

/// What the scene alone says about the plane under one light: the same for all settings.
struct SlbExtent {
  struct Range {
    double low = 0, high = 0;  ///< voxels
    double size() const { return high - low; }
    double middle() const { return 0.5 * (low + high); }
  };
  LightAxes axes;
  std::vector<bool> casts;  ///< by object
  Range right, up;          ///< of what casts, with its surround
  Range depth;              ///< of everything, along `axes.away`, with its reserve
};

/// `may_cast` and `light` as for plan_slb, which see; fails where it fails because of the scene.
Result<SlbExtent> slb_extent(const voxel::VoxelSet& voxels, const std::vector<bool>& may_cast,
                             const Vec3& light);

/// The plan for what slb_extent found. Fails where the settings make no legal hardware.
Result<SlbPlan> plan_slb(const SlbExtent& extent, const SlbSettings& settings);

/// `may_cast`: by object, whether it is to cast shadows at all; `light` is the way the light travels, in grid
/// coordinates. Fails where the settings make no legal hardware (the error names the key) or nothing casts a
/// shadow.
Result<SlbPlan> plan_slb(const voxel::VoxelSet& voxels, const std::vector<bool>& may_cast, const Vec3& light,
                         const SlbSettings& settings);

}  // namespace gnomon::plan
