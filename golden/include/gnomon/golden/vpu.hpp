// SPDX-License-Identifier: Apache-2.0
// The voxel projection unit, one voxel at a time: the equations of docs/vpu.md in integers. Every step is
// public so that it can be tested and explained on its own; the engine is these steps in a loop.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/narrow.hpp>
#include <gnomon/golden/perspective/view.hpp>

namespace gnomon::golden {

/// A point of the scene on the plane, before any narrowing.
struct Accumulators {
  std::int64_t u = 0, v = 0;  ///< entries, MATRIX_FRAC_BITS fraction bits
  std::int64_t d = 0;         ///< depth codes, P + 4 fraction bits
};

/// Where a point of the scene lands: entry and depth code.
struct PlanePoint {
  std::int64_t u = 0, v = 0;  ///< entry; any integer if not on_plane
  std::uint32_t depth = 0;    ///< saturated to 0..2^DEPTH_BITS - 2
  bool on_plane = false;
  bool saturated = false;
};

/// What one unit of the integer normal changes: u and v in entries (f fraction bits), d in depth codes (P +
/// 4).
struct Gradient {
  std::int64_t u = 0, v = 0, d = 0;
};

/// The unit's registers and its arithmetic.
class Vpu {
 public:
  /// `config` must be legal. Registers are 0.
  explicit Vpu(const HardwareConfig& config);

  /// Takes the low bits of `bits` that the register has.
  void set(Register reg, Word bits);
  std::int64_t get(Register reg) const { return registers_[static_cast<std::size_t>(reg)]; }

  /// Row by column, exact.
  Accumulators accumulate(const VoxelItem& item) const;
  /// Floor to the entry; floor and saturate the depth.
  PlanePoint land(const Accumulators& acc) const;
  /// Exact.
  Gradient gradient(const VoxelItem& item) const;
  /// The point moved outwards along its normal by OFFSET_FACTOR.
  PlanePoint land_offset(const Accumulators& acc, const Gradient& gradient) const;
  /// The slope-scaled margin test: true if `delta` is too much to be a surface's own slope.
  bool exceeds_margin(std::uint32_t delta, const Gradient& gradient) const;

  /// PROJECTION selects the perspective projection: what follows then takes the place of what stands above.
  bool in_perspective() const { return light_.registers().perspective; }
  const perspective::View& light() const { return light_; }
  perspective::Sight see(const VoxelItem& item) const;
  perspective::Slope slope(const VoxelItem& item) const;
  /// `sight` is not behind.
  PlanePoint land(const perspective::Sight& sight) const;
  PlanePoint land_offset(const perspective::Sight& sight, const perspective::Slope& slope) const;
  /// DELTA_MAX is a share of KEY_SCALE / w.
  std::uint32_t delta_limit(const perspective::Sight& sight) const;

  /// Index of an entry on the plane.
  std::size_t index(const PlanePoint& point) const {
    return (static_cast<std::size_t>(point.v) << plane_log2_) + static_cast<std::size_t>(point.u);
  }

 private:
  std::int64_t row(Register first, std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto i = static_cast<std::size_t>(first);
    return registers_[i] * x + registers_[i + 1] * y + registers_[i + 2] * z;
  }
  PlanePoint point(std::int64_t u, std::int64_t v, std::int64_t depth) const;
  void set_light(Register reg, std::int64_t value);

  HardwareConfig config_;
  std::array<std::int64_t, kAllRegisterCount> registers_{};
  perspective::View light_;
  int position_bits_, matrix_frac_bits_, depth_frac_bits_, plane_log2_;
  std::int64_t depth_max_;  ///< the farthest code that is not "empty"
};

inline Accumulators Vpu::accumulate(const VoxelItem& item) const {
  const auto& [x, y, z] = item.position;
  return {.u = row(Register::MatrixUx, x, y, z) + get(Register::MatrixU1),
          .v = row(Register::MatrixVx, x, y, z) + get(Register::MatrixV1),
          .d = row(Register::MatrixDx, x, y, z) + get(Register::MatrixD1)};
}

inline PlanePoint Vpu::point(std::int64_t u, std::int64_t v, std::int64_t depth) const {
  const std::int64_t code = saturate(depth, 0, depth_max_);
  return {.u = u,
          .v = v,
          .depth = static_cast<std::uint32_t>(code),
          .on_plane = fits_unsigned(u, plane_log2_) && fits_unsigned(v, plane_log2_),
          .saturated = code != depth};
}

inline PlanePoint Vpu::land(const Accumulators& acc) const {
  return point(narrow_floor(acc.u, matrix_frac_bits_), narrow_floor(acc.v, matrix_frac_bits_),
               narrow_floor(acc.d, depth_frac_bits_));
}

inline Gradient Vpu::gradient(const VoxelItem& item) const {
  const auto& [x, y, z] = item.normal;
  return {.u = row(Register::MatrixUx, x, y, z),
          .v = row(Register::MatrixVx, x, y, z),
          .d = row(Register::MatrixDx, x, y, z)};
}

inline PlanePoint Vpu::land_offset(const Accumulators& acc, const Gradient& gradient) const {
  const std::int64_t factor = get(Register::OffsetFactor);
  const std::int64_t u = acc.u + narrow_floor(factor * gradient.u, 16);
  const std::int64_t v = acc.v + narrow_floor(factor * gradient.v, 16);
  const std::int64_t d = narrow_floor(acc.d, position_bits_) +
                         narrow_floor(factor * narrow_floor(gradient.d, position_bits_), 16);
  return point(narrow_floor(u, matrix_frac_bits_), narrow_floor(v, matrix_frac_bits_), narrow_floor(d, 4));
}

inline perspective::Sight Vpu::see(const VoxelItem& item) const {
  const auto& [x, y, z] = item.position;
  return light_.see(row(Register::MatrixUx, x, y, z) + get(Register::MatrixU1),
                    row(Register::MatrixVx, x, y, z) + get(Register::MatrixV1), item.position);
}

inline perspective::Slope Vpu::slope(const VoxelItem& item) const {
  const auto& [x, y, z] = item.normal;
  return light_.slope(row(Register::MatrixUx, x, y, z), row(Register::MatrixVx, x, y, z), item);
}

inline PlanePoint Vpu::land(const perspective::Sight& sight) const {
  return point(narrow_floor(sight.u_fine, perspective::kEntryFracBits),
               narrow_floor(sight.v_fine, perspective::kEntryFracBits),
               narrow_floor(sight.key, perspective::kKeyFracBits));
}

inline PlanePoint Vpu::land_offset(const perspective::Sight& sight, const perspective::Slope& slope) const {
  const perspective::Moved moved = light_.move(sight, slope, get(Register::OffsetFactor), 0);
  return point(narrow_floor(moved.u, perspective::kEntryFracBits),
               narrow_floor(moved.v, perspective::kEntryFracBits),
               narrow_floor(moved.key, perspective::kKeyFracBits));
}

inline std::uint32_t Vpu::delta_limit(const perspective::Sight& sight) const {
  return static_cast<std::uint32_t>(
      narrow_floor(get(Register::DeltaMax) * sight.h, config_.depth_bits + perspective::kKeyFracBits));
}

inline bool Vpu::exceeds_margin(std::uint32_t delta, const Gradient& gradient) const {
  const auto shift = [this](Register reg) { return static_cast<int>(get(reg)); };
  const std::uint64_t delta_n = narrow_magnitude(delta, shift(Register::DeltaShift), 12);
  const std::uint64_t facing = narrow_magnitude(magnitude(gradient.d), shift(Register::FacingShift), 16);
  const std::uint64_t tilt_u = narrow_magnitude(magnitude(gradient.u), shift(Register::TiltShift), 16);
  const std::uint64_t tilt_v = narrow_magnitude(magnitude(gradient.v), shift(Register::TiltShift), 16);
  const std::uint64_t margin = static_cast<std::uint64_t>(get(Register::MarginSquared));
  const std::uint64_t side = delta_n * facing;
  return side * side > margin * (tilt_u * tilt_u + tilt_v * tilt_v);
}

}  // namespace gnomon::golden
