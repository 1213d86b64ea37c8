// SPDX-License-Identifier: Apache-2.0
// The parameters of the silhouette-line buffer, as the planner takes them.
#include "host/cli/slb_settings.hpp"

#include <bit>

namespace gnomon::cli {

plan::SlbSettings slb_settings(const config::Settings& settings) {
  const auto integer = [&](std::string_view key) { return static_cast<int>(settings.integer(key)); };
  plan::SlbSettings slb;
  slb.frac_bits = integer("frac_bits");
  slb.slope_bits = integer("slope_bits");
  slb.frags = integer("frags");
  slb.subpixel_bits = integer("subpixel_bits");
  slb.query_bits = integer("query_bits");
  slb.depth_bits = integer("depth_bits");
  slb.rounding = settings.word("rounding") == "published" ? golden::slb::Rounding::Published
                                                          : golden::slb::Rounding::Better;
  // The registry takes 0 and powers of two only.
  const auto plane = static_cast<unsigned>(integer("plane"));
  slb.plane_log2 = plane == 0 ? 0 : std::countr_zero(plane);
  return slb;
}

}  // namespace gnomon::cli
