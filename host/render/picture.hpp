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

#include "host/base/light.hpp"
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

/// A picture and what its shadows say, light by light and sample by sample. Where a spot's cone ends counts
/// as shadow.
struct Picture {
  Image image;
  std::vector<metrics::MaskValue>
      mask;  ///< lights x (width*supersample x height*supersample, row 0 at the bottom)
  std::size_t lights = 1;

  std::span<const metrics::MaskValue> mask_of(std::size_t light) const {
    const std::size_t samples = mask.size() / lights;
    return std::span(mask).subspan(light * samples, samples);
  }
};

inline constexpr std::uint32_t kNoPoint = 0xFFFFFFFF;

/// The surface points that a camera's samples see, row by row.
struct VisiblePoints {
  std::vector<Receiver> points;
  std::vector<std::uint32_t> of_sample;  ///< by sample, as one light's mask: index of its point, or kNoPoint
};

// A light in grid coordinates, and what decides about its shadow. What they refer to outlives the call.
struct StateShadows {
  Light light;
  std::span<const golden::VoxelState> states;  ///< Lit or Shadow, one per voxel
};
struct PointShadows {
  Light light;
  const VisiblePoints& points;
  std::span<const std::uint8_t> shadowed;  ///< 1 for shadow, one a point
};
struct ExactShadows {
  Light light;
  const metrics::ExactReference& reference;  ///< of that light
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

  /// Shadows from voxel states. A light's share follows the number of the subpatch's corners in its shadow;
  /// the mask of a sample is the state of the corner that is nearest in parameter space. Where a spot's cone
  /// ends is decided at the sample, and corners outside of it have no say.
  Picture render(const Camera& camera, std::span<const StateShadows> lights,
                 std::span<const Material> materials, const PictureOptions& options) const;
  /// The voxels whose states that picture asks for, ascending.
  std::vector<std::uint32_t> visible_voxels(const Camera& camera, const PictureOptions& options) const;
  /// Where the samples of that picture see a surface, and how it faces the light of `reference`, which also
  /// knows the surfaces that are two-sided.
  VisiblePoints visible_points(const Camera& camera, const metrics::ExactReference& reference,
                               const PictureOptions& options) const;
  /// The same view with an answer for every visible point.
  Picture render(const Camera& camera, std::span<const PointShadows> lights,
                 std::span<const Material> materials, const PictureOptions& options) const;
  /// The same view with exact shadows at every sample.
  Picture render_reference(const Camera& camera, std::span<const ExactShadows> lights,
                           std::span<const Material> materials, const PictureOptions& options) const;
  std::size_t triangles() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Red where `picture` is falsely in shadow, blue where falsely lit, over the dimmed grey reference; of
/// several lights each that is wrong at a sample has an equal part of it. Throws std::invalid_argument where
/// sizes differ.
Image error_map(const Picture& picture, const Picture& reference);

/// Share of the diffuse term that a subpatch keeps with n of its four corners in shadow: 1, 1/2, 1/4, 1/8, 0.
double diffuse_share(int corners_in_shadow);

}  // namespace gnomon::render
