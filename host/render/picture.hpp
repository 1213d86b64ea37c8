// SPDX-License-Identifier: Apache-2.0
// Pictures of a voxelized scene: its subpatches ray-cast, shadows from the voxel states or from the exact
// reference. Theory: docs/rendering.md.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/codec.hpp>
#include <memory>
#include <span>
#include <vector>

#include "host/base/receiver.hpp"
#include "host/base/result.hpp"
#include "host/metrics/image_error.hpp"
#include "host/metrics/shadow_truth.hpp"
#include "host/render/view.hpp"
#include "host/surface/limit_surface.hpp"

namespace gnomon::render {

/// sRGB, 8 bits, row 0 at the bottom (image y points up; the PNG writer turns it over, nobody else does).
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height
};

struct PictureOptions {
  int width = 1280, height = 960;
  int supersample = 3;                        ///< samples a pixel on each axis, 1..16
  std::function<void(double done)> progress;  ///< 0..1, one call at a time; may be empty
  std::function<bool()> cancelled;            ///< true: metrics::Cancelled is thrown; may be empty
};

/// A picture and, per sample, what its shadow says.
struct Picture {
  Image image;
  std::vector<metrics::MaskValue> mask;  ///< width*supersample x height*supersample, row 0 at the bottom
};

inline constexpr std::uint32_t kNoPoint = 0xFFFFFFFF;

/// The surface points that a camera's samples see, row by row.
struct VisiblePoints {
  std::vector<Receiver> points;
  std::vector<std::uint32_t> of_sample;  ///< by sample, as Picture::mask: index of its point, or kNoPoint
};

/// A scene ready to be looked at. Thread-safe.
class PictureScene {
 public:
  /// `voxels` needs subpatches and representatives; both references must outlive the scene.
  /// Throws std::invalid_argument if the subpatches are missing.
  PictureScene(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& voxels);
  PictureScene(PictureScene&&) noexcept;
  PictureScene& operator=(PictureScene&&) noexcept;
  ~PictureScene();

  /// Shadows from `states` (one per voxel, Lit or Shadow). The colour follows the number of the subpatch's
  /// corners in shadow; the mask of a sample is the state of the corner that is nearest in parameter space.
  Picture render(const Camera& camera, const Light& light, std::span<const Material> materials,
                 std::span<const golden::VoxelState> states, const PictureOptions& options) const;
  /// Where the samples of that picture see a surface. `reference` knows which surfaces are two-sided.
  VisiblePoints visible_points(const Camera& camera, const metrics::ExactReference& reference,
                               const PictureOptions& options) const;
  /// The same view with a shadow for every visible point: `shadowed` runs as points.points.
  Picture render(const Camera& camera, const Light& light, std::span<const Material> materials,
                 const VisiblePoints& points, std::span<const std::uint8_t> shadowed,
                 const PictureOptions& options) const;
  /// The same view with exact shadows at every sample.
  Picture render_reference(const Camera& camera, const Light& light, std::span<const Material> materials,
                           const metrics::ExactReference& reference, const PictureOptions& options) const;
  std::size_t triangles() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Red where `picture` is falsely in shadow, blue where falsely lit, over the dimmed grey reference. Throws
/// std::invalid_argument where sizes differ.
Image error_map(const Picture& picture, const Picture& reference);

/// Share of the diffuse term that a subpatch keeps with n of its four corners in shadow: 1, 1/2, 1/4, 1/8, 0.
double diffuse_share(int corners_in_shadow);

}  // namespace gnomon::render
