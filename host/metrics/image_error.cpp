// SPDX-License-Identifier: Apache-2.0
// Counts over shadow masks, and RMSE.
#include "host/metrics/image_error.hpp"

#include <cmath>
#include <stdexcept>

namespace gnomon::metrics {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

double MaskError::false_shadow_share() const {
  return share(false_shadow, receivers);
}
double MaskError::false_lit_share() const {
  return share(false_lit, receivers);
}
double MaskError::iou() const {
  const std::uint64_t either = both_shadow + false_shadow + false_lit;
  return either == 0 ? 1.0 : share(both_shadow, either);
}

MaskError mask_error(std::span<const MaskValue> mask, std::span<const MaskValue> reference) {
  if (mask.size() != reference.size()) throw std::invalid_argument("shadow masks differ in size");
  MaskError error;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const bool background = reference[i] == MaskValue::Background;
    if (background != (mask[i] == MaskValue::Background))
      throw std::invalid_argument("shadow masks see different geometry");
    if (background) continue;
    const bool shadow = mask[i] == MaskValue::Shadow;
    const bool exact = reference[i] == MaskValue::Shadow;
    ++error.receivers;
    if (shadow && exact) ++error.both_shadow;
    if (shadow && !exact) ++error.false_shadow;
    if (!shadow && exact) ++error.false_lit;
  }
  return error;
}

double rmse(std::span<const std::uint8_t> image, std::span<const std::uint8_t> reference) {
  if (image.size() != reference.size()) throw std::invalid_argument("images differ in size");
  if (image.empty()) return 0.0;
  double sum = 0;
  for (std::size_t i = 0; i < image.size(); ++i) {
    const double difference = (double{1} * image[i] - reference[i]) / 255;
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(image.size()));
}

}  // namespace gnomon::metrics
