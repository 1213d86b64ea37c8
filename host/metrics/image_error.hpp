// SPDX-License-Identifier: Apache-2.0
// How far a picture is from the reference: shadow masks and RMSE. Definitions: docs/error-metrics.md.
#pragma once

#include <cstdint>
#include <span>

namespace gnomon::metrics {

/// What a shadow mask says of one pixel sample.
enum class MaskValue : std::uint8_t { Background = 0, Lit = 1, Shadow = 2 };

struct MaskError {
  std::uint64_t receivers = 0;     ///< samples that see a surface
  std::uint64_t false_shadow = 0;  ///< shadow where the reference is lit
  std::uint64_t false_lit = 0;
  std::uint64_t both_shadow = 0;      ///< intersection of the two masks
  double false_shadow_share() const;  ///< of receivers, 0..1
  double false_lit_share() const;
  /// Intersection over union of the shadow masks, 0..1; 1 where neither has a shadow.
  double iou() const;
};

/// Both masks see the same geometry; throws std::invalid_argument where sizes or backgrounds differ.
MaskError mask_error(std::span<const MaskValue> mask, std::span<const MaskValue> reference);

/// Root mean square difference of two sRGB byte images, over all channels, in units of full scale (0..1).
double rmse(std::span<const std::uint8_t> image, std::span<const std::uint8_t> reference);

}  // namespace gnomon::metrics
