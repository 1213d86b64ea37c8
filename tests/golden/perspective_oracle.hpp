// SPDX-License-Identifier: Apache-2.0
// The perspective projection of docs/vpu.md and the beam of docs/vpu-topology.md in exact rationals: every
// named rounding is a rounding of a real number. Shares no arithmetic with the golden model.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/golden/exact_oracle.hpp"
#include "tests/support/perspective_registers.hpp"

namespace gnomon::exact {

/// The reciprocal of a mantissa 1 <= m < 2 with 23 fraction bits.
Rational reciprocal(const Rational& mantissa);

/// A point as the light sees it; distances in entries and depth codes.
struct Sight {
  bool behind = true;
  int exponent = 0;           ///< of w
  Rational r;                 ///< reciprocal of w's mantissa
  std::array<Rational, 2> x;  ///< entries from the axis
  std::array<Rational, 2> fine;
  Rational h, key;
};

/// A point moved along the normal, along the beam of the point it came from.
struct Moved {
  std::array<Rational, 2> fine;
  Rational key;
};

class PerspectiveUnit {
 public:
  PerspectiveUnit(const golden::HardwareConfig& config, const stimulus::AllRegisters& registers);

  Sight see(const golden::VoxelItem& item) const;
  bool outside_cone(const Sight& sight) const;
  /// N by the way from the light, position ulps.
  Rational descent(const golden::VoxelItem& item) const;
  /// `turned`: N is negated. `clearance` of RESOLVE_TOPOLOGY, or 0.
  Moved move(const golden::VoxelItem& item, const Sight& sight, bool turned, std::uint32_t clearance) const;

  Landing land(const Sight& sight) const {
    return {floor(sight.fine[0]), floor(sight.fine[1]), floor(sight.key)};
  }
  Landing land(const Moved& moved) const {
    return {floor(moved.fine[0]), floor(moved.fine[1]), floor(moved.key)};
  }
  Integer delta_limit(const Sight& sight) const;
  bool exceeds_margin(const Integer& delta, const golden::VoxelItem& item) const;
  /// For on_plane and saturated.
  const Unit& plane() const { return unit_; }

  /// w as it is, and the point's true place and depth without any rounding but the registers'.
  Rational w(const golden::VoxelItem& item) const;

  /// Every intermediate value of an item that is not behind; none of one that is but its w.
  std::vector<NamedValue> intermediates(const golden::VoxelItem& item, std::uint32_t clearance) const;

 private:
  Rational value(golden::Register reg) const;
  Rational row(golden::Register first, const std::array<Rational, 3>& at) const;
  std::array<Rational, 3> from_light(const golden::VoxelItem& item) const;

  golden::HardwareConfig config_;
  stimulus::AllRegisters registers_;
  Unit unit_;
};

void project(Plane& plane, const PerspectiveUnit& unit, const golden::VoxelItem& item);
golden::VoxelResult resolve(const Plane& plane, const PerspectiveUnit& unit, const golden::VoxelItem& item,
                            bool two_sided);

}  // namespace gnomon::exact
