// SPDX-License-Identifier: Apache-2.0
// Legal combinations, derived widths and presets (docs/slb.md, "Parameters").
#include <bit>
#include <gnomon/golden/slb/config.hpp>

namespace gnomon::golden::slb {
namespace {

std::optional<std::string> out_of_range(const char* name, int value, int low, int high) {
  if (value >= low && value <= high) return std::nullopt;
  return std::string(name) + "=" + std::to_string(value) + " is out of range " + std::to_string(low) + ".." +
         std::to_string(high);
}

/// Bits that hold 0..largest.
int bits_for(int largest) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(largest)));
}

}  // namespace

std::optional<std::string> SlbConfig::check() const {
  if (auto error = out_of_range("FRAC_BITS", frac_bits, 3, 8)) return error;
  if (auto error = out_of_range("SLOPE_BITS", slope_bits, 3, 9)) return error;
  if (auto error = out_of_range("FRAGS_PER_PIXEL", frags, 1, kMaxFrags)) return error;
  if (auto error = out_of_range("DEPTH_BITS", depth_bits, 8, 24)) return error;
  if (auto error = out_of_range("SLB_PLANE_LOG2", plane_log2, 3, 16)) return error;
  if (auto error = out_of_range("SUBPIXEL_BITS", subpixel_bits, frac_bits + 3, 16)) return error;
  if (auto error = out_of_range("QUERY_BITS", query_bits, frac_bits + 3, 16)) return error;
  if (subpixel_bits < slope_bits - frac_bits + 4)
    return "SUBPIXEL_BITS=" + std::to_string(subpixel_bits) +
           " is below SLOPE_BITS - FRAC_BITS + 4 = " + std::to_string(slope_bits - frac_bits + 4);
  // Products of two coordinates then fit 64 bits everywhere.
  if (vertex_width() > 28 || query_width() > 28)
    return "SLB_PLANE_LOG2=" + std::to_string(plane_log2) +
           " with SUBPIXEL_BITS=" + std::to_string(subpixel_bits) +
           " and QUERY_BITS=" + std::to_string(query_bits) + ": a coordinate has more than 28 bits";
  return std::nullopt;
}

int SlbConfig::threshold_bits() const {
  return bits_for(2 * frags - 1);
}
int SlbConfig::count_bits() const {
  return bits_for(frags);
}
int SlbConfig::fragment_bits() const {
  return depth_bits + 8 + 2 + 2 * line_bits() + threshold_bits() + 1;
}
int SlbConfig::entry_bits() const {
  return kGenerationBits + count_bits() + 2 + kCornerBits + depth_bits + frags * fragment_bits();
}
int SlbConfig::stored_entry_bits() const {
  const int bits = static_cast<int>(std::bit_ceil(static_cast<unsigned>(entry_bits())));
  return bits < 64 ? 64 : bits;
}

SlbConfig slb4() {
  SlbConfig config;
  config.frac_bits = config.slope_bits = 4;
  config.subpixel_bits = config.query_bits = 7;
  return config;
}

SlbConfig slb7() {
  return SlbConfig{};
}

}  // namespace gnomon::golden::slb
