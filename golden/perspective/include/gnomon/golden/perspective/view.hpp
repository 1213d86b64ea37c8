// SPDX-License-Identifier: Apache-2.0
// What a light at a position sees of the grid: the equations of docs/vpu.md, "Perspective", in integers. Both
// modes of the projection unit use it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <gnomon/golden/narrow.hpp>
#include <gnomon/golden/perspective/reciprocal.hpp>

namespace gnomon::golden::perspective {

inline constexpr int kEntryFracBits = 12;   ///< of positions on the plane
inline constexpr int kRatioFracBits = 20;   ///< of rho and rho_c
inline constexpr int kKeyFracBits = 4;      ///< of depth keys
inline constexpr int kLightFracBits = 3;    ///< of LIGHT_X..Z, position ulps
inline constexpr int kConeFracBits = 8;     ///< of the radius that CONE_SQUARED is the square of
inline constexpr int kClearanceBits = 24;   ///< of the argument of RESOLVE_TOPOLOGY
inline constexpr int kOffsetFracBits = 16;  ///< of OFFSET_FACTOR

/// Parameters of the build that widths depend on.
struct Format {
  int position_bits = 10;     ///< P
  int matrix_frac_bits = 22;  ///< f
  int depth_bits = 20;        ///< D
  int plane_log2 = 9;         ///< p
};

/// The registers from PROJECTION on, cut to their widths.
struct Registers {
  bool perspective = false, cone = false;  ///< PROJECTION
  std::array<std::int64_t, 4> w{};         ///< MATRIX_WX..W1
  std::int64_t w_near = 0;
  std::array<std::int64_t, 2> centre{};  ///< CENTRE_U, CENTRE_V
  std::int64_t key_limit = 0, key_scale = 0;
  std::array<std::int64_t, 3> light{};  ///< LIGHT_X..Z
  std::int64_t cone_squared = 0;
};

/// A point of the scene as the light sees it. Nothing but `behind` means anything behind the light.
struct Sight {
  bool behind = true;
  int k = 0;                            ///< floor(log2 w) + P
  std::int64_t r = 0;                   ///< reciprocal of w's mantissa
  std::int64_t x_u = 0, x_v = 0;        ///< entries from the axis, 12 fraction bits
  std::int64_t u_fine = 0, v_fine = 0;  ///< entries, 12 fraction bits
  std::int64_t h = 0;                   ///< KEY_SCALE / w, 4 fraction bits
  std::int64_t key = 0;                 ///< depth code before the floor, 4 fraction bits
};

/// What one unit of the integer normal changes (u, v: f fraction bits; w: f + P), and the normal by the way
/// from the light.
struct Slope {
  std::int64_t u = 0, v = 0, w = 0, d = 0;
  Slope operator-() const { return {-u, -v, -w, -d}; }
};

/// A point moved along the normal, seen along the beam of the point it came from.
struct Moved {
  std::int64_t u = 0, v = 0;  ///< entries, 12 fraction bits
  std::int64_t key = 0;       ///< 4 fraction bits
};

class View {
 public:
  View(const Format& format, const Registers& registers) : format_(format), registers_(registers) {}

  const Registers& registers() const { return registers_; }
  Registers& registers() { return registers_; }

  /// `u_acc` and `v_acc` are those of the orthographic projection.
  template <typename Position>
  Sight see(std::int64_t u_acc, std::int64_t v_acc, const Position& position) const;
  bool outside_cone(const Sight& sight) const;
  /// `u` and `v` are those of the orthographic gradient.
  template <typename Item>
  Slope slope(std::int64_t u, std::int64_t v, const Item& item) const;
  /// `factor` is OFFSET_FACTOR; `clearance` that of RESOLVE_TOPOLOGY, 0 otherwise. `sight` is not behind.
  Moved move(const Sight& sight, const Slope& slope, std::int64_t factor, std::int64_t clearance) const;

 private:
  /// value * 2^(frac - f - k), floored, saturated to `width` bits: as fine as the mantissa of w.
  std::int64_t normalise(std::int64_t value, int frac, int k, int width) const {
    const int dropped = format_.matrix_frac_bits + k - frac;
    const std::int64_t shifted = dropped >= 0 ? value >> dropped : value << -dropped;
    const std::int64_t limit = std::int64_t{1} << (width - 1);
    return saturate(shifted, -limit, limit - 1);
  }
  std::int64_t on_plane(std::int64_t value, int k) const {
    return normalise(value, format_.position_bits + kEntryFracBits, k, format_.plane_log2 + 16);
  }
  static std::int64_t times_reciprocal(std::int64_t value, std::int64_t r) {
    return (value * r) >> kMantissaBits;
  }

  Format format_;
  Registers registers_;
};

template <typename Position>
inline Sight View::see(std::int64_t u_acc, std::int64_t v_acc, const Position& position) const {
  const auto& [wx, wy, wz, w1] = registers_.w;
  const int f = format_.matrix_frac_bits, p = format_.position_bits;
  const std::int64_t w_acc = wx * position[0] + wy * position[1] + wz * position[2] + w1;
  const std::int64_t w_high = w_acc >> f;
  Sight sight;
  sight.behind = w_high < std::max<std::int64_t>(registers_.w_near, 1);
  if (sight.behind) return sight;
  sight.k = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(w_high))) - 1;
  const int below = f + sight.k - (kMantissaBits - 1);  // bits of w below its mantissa
  sight.r = reciprocal(static_cast<std::uint32_t>(below >= 0 ? w_acc >> below : w_acc << -below));
  sight.x_u = times_reciprocal(on_plane(u_acc, sight.k), sight.r);
  sight.x_v = times_reciprocal(on_plane(v_acc, sight.k), sight.r);
  sight.u_fine = sight.x_u + registers_.centre[0] * (1 << kEntryFracBits);
  sight.v_fine = sight.x_v + registers_.centre[1] * (1 << kEntryFracBits);
  const std::int64_t most = (std::int64_t{1} << (format_.depth_bits + 8)) - 1;
  sight.h = std::min((registers_.key_scale * sight.r) >> (kMantissaBits + sight.k - p), most);
  sight.key = registers_.key_limit - sight.h;
  return sight;
}

inline bool View::outside_cone(const Sight& sight) const {
  if (!registers_.cone) return false;
  constexpr int kDropped = kEntryFracBits - kConeFracBits;
  const std::int64_t u = sight.x_u >> kDropped, v = sight.x_v >> kDropped;
  return u * u + v * v > registers_.cone_squared;
}

template <typename Item>
inline Slope View::slope(std::int64_t u, std::int64_t v, const Item& item) const {
  Slope slope{.u = u, .v = v};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t n = item.normal[i];
    constexpr std::int64_t kReadPoint = 1 << (kLightFracBits - 1);  // half an ulp
    const std::int64_t beam =
        std::int64_t{item.position[i]} * (1 << kLightFracBits) + kReadPoint - registers_.light[i];
    slope.w += registers_.w[i] * n;
    slope.d += beam * n;
  }
  return slope;
}

inline Moved View::move(const Sight& sight, const Slope& slope, std::int64_t factor,
                        std::int64_t clearance) const {
  const auto step = [&](std::int64_t g) { return (factor * g) >> kOffsetFracBits; };
  const std::int64_t q_dw = normalise(step(slope.w), kRatioFracBits, sight.k, kRatioFracBits + 2);
  const std::int64_t rho = times_reciprocal(q_dw, sight.r);
  const auto moved = [&](std::int64_t fine, std::int64_t from_axis, std::int64_t g) {
    const std::int64_t along = times_reciprocal(on_plane(step(g), sight.k), sight.r);
    return fine + along - ((from_axis * rho) >> kRatioFracBits);
  };
  // clearance * 2^(8 - k): P + 12 fraction bits as against w's.
  const std::int64_t q_c = std::min(sight.k <= 8 ? clearance << (8 - sight.k) : clearance >> (sight.k - 8),
                                    (std::int64_t{1} << (kRatioFracBits + 1)) - 1);
  const std::int64_t rho_c = times_reciprocal(q_c, sight.r);
  return {.u = moved(sight.u_fine, sight.x_u, slope.u),
          .v = moved(sight.v_fine, sight.x_v, slope.v),
          .key = sight.key + ((sight.h * (rho - rho_c)) >> kRatioFracBits)};
}

}  // namespace gnomon::golden::perspective
