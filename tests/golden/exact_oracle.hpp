// SPDX-License-Identifier: Apache-2.0
// The equations of docs/vpu.md in exact rationals: registers and items become the real numbers they stand
// for, and every named rounding is a rounding of a real number. Shares no arithmetic with the golden model.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <map>
#include <utility>
#include <vector>

#include "tests/support/scene_registers.hpp"

namespace gnomon::exact {

// Without expression templates: every intermediate result is a value of its own.
using IntegerBackend = boost::multiprecision::cpp_int_backend<>;
using Integer = boost::multiprecision::number<IntegerBackend, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::rational_adaptor<IntegerBackend>,
                                               boost::multiprecision::et_off>;

/// Largest integer not above x.
Integer floor(const Rational& x);
/// Largest multiple of 2^-bits not above x; bits may be negative.
Rational floor_to(const Rational& x, int bits);
/// 2^exponent; the exponent may be negative.
Rational power_of_two(int exponent);

/// A value with the name docs/number-formats.md gives it, as the integer that the hardware would hold.
struct NamedValue {
  const char* name;
  Integer held;
};

struct Landing {
  Integer u, v, d;  ///< d not yet saturated
};

/// The unit with its registers; knows nothing of the plane.
class Unit {
 public:
  Unit(const golden::HardwareConfig& config, const stimulus::RegisterValues& registers);

  /// Entries and depth codes of a position, exact.
  std::array<Rational, 3> project(const golden::VoxelItem& item) const;
  /// Change of these along one unit of the integer normal, exact.
  std::array<Rational, 3> gradient(const golden::VoxelItem& item) const;
  Landing land(const std::array<Rational, 3>& point) const;
  Landing land_offset(const std::array<Rational, 3>& point, const std::array<Rational, 3>& gradient) const;
  bool exceeds_margin(const Integer& delta, const std::array<Rational, 3>& gradient) const;

  /// DELTA_MAX.
  Integer limit() const { return held(golden::Register::DeltaMax); }
  bool on_plane(const Landing& landing) const;
  std::uint32_t saturated(const Integer& depth) const;
  bool saturates(const Integer& depth) const { return Integer(saturated(depth)) != depth; }

  /// Every intermediate value for the item, the offset of either sign of the normal included; `code` is what
  /// the offset point's entry holds.
  std::vector<NamedValue> intermediates(const golden::VoxelItem& item, std::uint32_t code) const;

 private:
  Rational value(golden::Register reg) const;
  Integer held(golden::Register reg) const;
  Integer scaled(const Rational& magnitude, int frac_bits, golden::Register shift, int width) const;

  golden::HardwareConfig config_;
  stimulus::RegisterValues registers_;
};

/// What a register holds after a write of `word`.
std::int64_t register_value(std::size_t index, golden::Word word, const golden::HardwareConfig& config);

/// A plane that remembers nothing but the nearest depth of each entry.
using Plane = std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t>;

void project(Plane& plane, const Unit& unit, const golden::VoxelItem& item);
golden::VoxelResult resolve(const Plane& plane, const Unit& unit, const golden::VoxelItem& item,
                            bool two_sided);

}  // namespace gnomon::exact
