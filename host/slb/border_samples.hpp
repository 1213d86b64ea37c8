// SPDX-License-Identifier: Apache-2.0
// Mean border displacement of the buffer and of shadow maps against exact polygons (docs/error-metrics.md,
// "Polygons").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/query.hpp>
#include <span>
#include <vector>

#include "host/slb/polygon_reference.hpp"

namespace gnomon::slb {

struct SampleOptions {
  int per_pixel = 256;     ///< samples in a pixel that an outline touches, rounded up to a square number
  std::uint64_t seed = 1;  ///< of their places
};

/// Points behind every caster, with their exact answers and those of two shadow maps.
struct BorderSamples {
  std::vector<golden::slb::QueryPoint> queries;
  std::vector<float> weights;  ///< square pixels that a point stands for
  std::vector<bool> shadow;    ///< exact, at the point that the unit reads
  double plain_wrong = 0;      ///< square pixels that a shadow map of the plane's resolution answers wrongly
  double fine_wrong = 0;       ///< of one 2^FRAC_BITS times finer on both axes
  double border = 0;           ///< length of the border between shadow and light on the plane, pixels
};

/// Points in random places of a regular grid in every pixel of the plane: `per_pixel` of them in pixels that
/// an outline touches, an eighth as many in the pixels around these, one in all others.
BorderSamples border_samples(const PolygonReference& reference, const golden::slb::SlbConfig& config,
                             const SampleOptions& options);

/// Displacements in pixels: wrongly answered area / border. 0 where there is no border.
struct Displacement {
  double buffer = 0, plain_map = 0, fine_map = 0;
  double border = 0;  ///< pixels
  std::uint64_t samples = 0, wrong = 0;

  /// Of the buffer over that of the finer map; 0 if that has none.
  double ratio() const { return fine_map > 0 ? buffer / fine_map : 0; }
  /// How many times the buffer is better than a map of its own resolution; 0 if it is perfect.
  double gain() const { return buffer > 0 ? plain_map / buffer : 0; }
};
/// `answers` of the samples' queries, in their order.
Displacement displacement(const BorderSamples& samples, std::span<const golden::slb::QueryAnswer> answers);

}  // namespace gnomon::slb
