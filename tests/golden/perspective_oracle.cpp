// SPDX-License-Identifier: Apache-2.0
// Real numbers, rounded where the page says so.
#include "tests/golden/perspective_oracle.hpp"

#include <algorithm>

namespace gnomon::exact {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::VoxelItem;
using golden::VoxelResult;
using golden::VoxelState;

/// The floor to `bits` fraction bits, then the nearest number below `limit` and not below -limit.
Rational narrow(const Rational& x, int bits, const Rational& limit) {
  return std::clamp<Rational>(floor_to(x, bits), -limit, limit - power_of_two(-bits));
}

/// Largest e with 2^e <= x.
int floor_log2(const Rational& x) {
  int e = 0;
  while (power_of_two(e) > x) --e;
  while (power_of_two(e + 1) <= x) ++e;
  return e;
}

Integer held(const Rational& x, int frac) {
  const Rational scaled = x * power_of_two(frac);
  if (denominator(scaled) != 1) throw std::logic_error("a value has more fraction bits than its format");
  return numerator(scaled);
}

stimulus::RegisterValues first_registers(const stimulus::AllRegisters& registers) {
  stimulus::RegisterValues values{};
  std::copy_n(registers.begin(), values.size(), values.begin());
  return values;
}

Rational seed_of(const Rational& mantissa) {
  const Rational middle = floor_to(mantissa, 9) + power_of_two(-10);
  return floor_to(1 / middle + power_of_two(-17), 16);
}

std::array<Rational, 3> numbers(const std::array<std::int32_t, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

Rational reciprocal(const Rational& mantissa) {
  const Rational seed = seed_of(mantissa);
  return floor_to(seed * floor_to(2 - mantissa * seed, 24), 24);
}

PerspectiveUnit::PerspectiveUnit(const HardwareConfig& config, const stimulus::AllRegisters& registers)
    : config_(config), registers_(registers), unit_(config, first_registers(registers)) {}

Rational PerspectiveUnit::value(Register reg) const {
  const int frac = golden::register_format(reg, config_).frac_bits;
  return Rational(registers_[static_cast<std::size_t>(reg)]) * power_of_two(-frac);
}

Rational PerspectiveUnit::row(Register first, const std::array<Rational, 3>& at) const {
  Rational sum = 0;
  for (int axis = 0; axis < 3; ++axis)
    sum += value(static_cast<Register>(static_cast<int>(first) + axis)) * at[static_cast<std::size_t>(axis)];
  return sum;
}

Rational PerspectiveUnit::w(const VoxelItem& item) const {
  return row(Register::MatrixWx, {item.position[0], item.position[1], item.position[2]}) +
         value(Register::MatrixW1);
}

Sight PerspectiveUnit::see(const VoxelItem& item) const {
  Sight sight;
  const int p = config_.position_bits();
  const Rational high = floor_to(w(item), p);
  sight.behind = high < std::max<Rational>(value(Register::WNear), power_of_two(-p));
  if (sight.behind) return sight;
  sight.exponent = floor_log2(high);
  const Rational scale = power_of_two(-sight.exponent);
  sight.r = reciprocal(floor_to(w(item) * scale, 23));
  const auto homogeneous = unit_.project(item);
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational q = narrow(homogeneous[i] * scale, 12, power_of_two(config_.plane_log2 + 3));
    sight.x[i] = floor_to(q * sight.r, 12);
    sight.fine[i] = sight.x[i] + value(i == 0 ? Register::CentreU : Register::CentreV);
  }
  sight.h = narrow(value(Register::KeyScale) * sight.r * scale, 4, power_of_two(config_.depth_bits + 4));
  sight.key = value(Register::KeyLimit) - sight.h;
  return sight;
}

bool PerspectiveUnit::outside_cone(const Sight& sight) const {
  if ((registers_[static_cast<std::size_t>(Register::Projection)] & golden::kProjectionCone) == 0)
    return false;
  const Rational u = floor_to(sight.x[0], 8), v = floor_to(sight.x[1], 8);
  return u * u + v * v > value(Register::ConeSquared);
}

std::array<Rational, 3> PerspectiveUnit::from_light(const VoxelItem& item) const {
  std::array<Rational, 3> way;
  for (std::size_t i = 0; i < 3; ++i)
    way[i] = item.position[i] + power_of_two(-1) -
             value(static_cast<Register>(static_cast<std::size_t>(Register::LightX) + i));
  return way;
}

Rational PerspectiveUnit::descent(const VoxelItem& item) const {
  const auto way = from_light(item);
  return way[0] * item.normal[0] + way[1] * item.normal[1] + way[2] * item.normal[2];
}

Moved PerspectiveUnit::move(const VoxelItem& item, const Sight& sight, bool turned,
                            std::uint32_t clearance) const {
  const int sign = turned ? -1 : 1, f = config_.matrix_frac_bits, p = config_.position_bits();
  const Rational scale = power_of_two(-sight.exponent);
  const Rational factor = value(Register::OffsetFactor) * sign;
  const auto gradient = unit_.gradient(item);
  const Rational w_step = floor_to(factor * row(Register::MatrixWx, numbers(item.normal)), f + p);
  const Rational rho = floor_to(narrow(w_step * scale, 20, 2) * sight.r, 20);
  Moved moved;
  for (std::size_t i = 0; i < 2; ++i) {
    const Rational step = floor_to(factor * gradient[i], f);
    const Rational q = narrow(step * scale, 12, power_of_two(config_.plane_log2 + 3));
    moved.fine[i] = sight.fine[i] + floor_to(q * sight.r, 12) - floor_to(sight.x[i] * rho, 12);
  }
  const Rational distance = Rational(clearance) * power_of_two(-p - 12);
  const Rational rho_c = floor_to(narrow(distance * scale, 20, 2) * sight.r, 20);
  moved.key = sight.key + floor_to(sight.h * (rho - rho_c), 4);
  return moved;
}

Integer PerspectiveUnit::delta_limit(const Sight& sight) const {
  return floor(value(Register::DeltaMax) * power_of_two(-config_.depth_bits) * sight.h);
}

bool PerspectiveUnit::exceeds_margin(const Integer& delta, const VoxelItem& item) const {
  auto gradient = unit_.gradient(item);
  // The unit reads g_d with P + 4 fraction bits; here it has 3.
  gradient[2] = descent(item) * power_of_two(3 - config_.position_bits() - 4);
  return unit_.exceeds_margin(delta, gradient);
}

std::vector<NamedValue> PerspectiveUnit::intermediates(const VoxelItem& item, std::uint32_t clearance) const {
  const int f = config_.matrix_frac_bits, p = config_.position_bits();
  std::vector<NamedValue> values{{"w_acc", held(w(item), f + p)}, {"w_high", held(floor_to(w(item), p), p)}};
  for (const Rational& b : from_light(item)) values.push_back({"b", held(b, 3)});
  values.push_back({"g_d_from_light", held(descent(item), 3)});
  values.push_back({"g_w", held(row(Register::MatrixWx, numbers(item.normal)), f + p)});
  const Sight sight = see(item);
  if (sight.behind) return values;
  const Rational scale = power_of_two(-sight.exponent);
  const Rational m = floor_to(w(item) * scale, 23), seed = seed_of(m);
  values.push_back({"k", sight.exponent + p});
  values.push_back({"m", held(m, 23)});
  values.push_back({"seed", held(seed, 16)});
  values.push_back({"t", held(floor_to(2 - m * seed, 24), 24)});
  values.push_back({"r", held(sight.r, 24)});
  const auto homogeneous = unit_.project(item);
  const Rational plane_limit = power_of_two(config_.plane_log2 + 3);
  Rational cone_sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    values.push_back({"q_u", held(narrow(homogeneous[i] * scale, 12, plane_limit), 12)});
    values.push_back({"x_u", held(sight.x[i], 12)});
    values.push_back({"u_fine", held(sight.fine[i], 12)});
    cone_sum += floor_to(sight.x[i], 8) * floor_to(sight.x[i], 8);
  }
  values.push_back({"cone_sum", held(cone_sum, 16)});
  values.push_back({"h", held(sight.h, 4)});
  values.push_back({"key", held(sight.key, 4)});
  values.push_back({"delta_limit", delta_limit(sight)});
  for (const bool turned : {false, true}) {
    const Rational factor = value(Register::OffsetFactor) * (turned ? -1 : 1);
    const Rational g_w = row(Register::MatrixWx, numbers(item.normal));
    const Rational w_step = floor_to(factor * g_w, f + p);
    const Rational q_dw = narrow(w_step * scale, 20, 2), rho = floor_to(q_dw * sight.r, 20);
    values.push_back({"w_step_product", held(factor * g_w, f + p + 16)});
    values.push_back({"w_step", held(w_step, f + p)});
    values.push_back({"q_dw", held(q_dw, 20)});
    values.push_back({"rho", held(rho, 20)});
    const auto gradient = unit_.gradient(item);
    const Moved moved = move(item, sight, turned, 0), cleared = move(item, sight, turned, clearance);
    for (std::size_t i = 0; i < 2; ++i) {
      const Rational q = narrow(floor_to(factor * gradient[i], f) * scale, 12, plane_limit);
      values.push_back({"q_du", held(q, 12)});
      values.push_back({"x_du", held(floor_to(q * sight.r, 12), 12)});
      values.push_back({"x_turn", held(floor_to(sight.x[i] * rho, 12), 12)});
      values.push_back({"u_moved_fine", held(moved.fine[i], 12)});
    }
    const Rational q_c = narrow(Rational(clearance) * power_of_two(-p - 12) * scale, 20, 2);
    const Rational rho_c = floor_to(q_c * sight.r, 20);
    values.push_back({"h_step", held(moved.key - sight.key, 4)});
    values.push_back({"key_moved", held(moved.key, 4)});
    values.push_back({"q_c", held(q_c, 20)});
    values.push_back({"rho_c", held(rho_c, 20)});
    values.push_back({"rho_a", held(rho - rho_c, 20)});
    values.push_back({"a_step", held(cleared.key - sight.key, 4)});
    values.push_back({"key_a", held(cleared.key, 4)});
  }
  return values;
}

void project(Plane& plane, const PerspectiveUnit& unit, const VoxelItem& item) {
  const Sight sight = unit.see(item);
  if (sight.behind) return;
  const Landing landing = unit.land(sight);
  if (!unit.plane().on_plane(landing)) return;
  const std::uint32_t depth = unit.plane().saturated(landing.d);
  const auto [place, fresh] =
      plane.try_emplace({landing.u.convert_to<std::int64_t>(), landing.v.convert_to<std::int64_t>()}, depth);
  if (!fresh) place->second = std::min(place->second, depth);
}

VoxelResult resolve(const Plane& plane, const PerspectiveUnit& unit, const VoxelItem& item, bool two_sided) {
  const Sight sight = unit.see(item);
  if (sight.behind) return {.state = VoxelState::Shadow, .behind = true};
  const auto depth_at = [&](const Landing& at) {
    const auto found = unit.plane().on_plane(at)
                           ? plane.find({at.u.convert_to<std::int64_t>(), at.v.convert_to<std::int64_t>()})
                           : plane.end();
    return found == plane.end() ? Integer(-1) : Integer(found->second);
  };
  const Landing own = unit.land(sight);
  VoxelResult result{.state = VoxelState::Shadow, .off_plane = !unit.plane().on_plane(own)};
  result.outside_cone = unit.outside_cone(sight);
  if (result.outside_cone) return result;
  const Rational descent = unit.descent(item);
  const bool turned = two_sided && descent > 0;
  result.facing_away = turned ? false : descent >= 0;
  if (result.facing_away) return result;
  result.state = VoxelState::Lit;
  const Integer nearest = depth_at(own);
  if (nearest < 0) return result;
  result.nearest = nearest.convert_to<std::uint32_t>();
  result.uncertain = nearest < unit.plane().saturated(own.d);
  if (!result.uncertain) return result;
  const Landing moved = unit.land(unit.move(item, sight, turned, 0));
  const Integer beyond = depth_at(moved);
  result.offset_empty = beyond < 0;
  const Integer delta = Integer(unit.plane().saturated(moved.d)) - beyond;
  if (result.offset_empty || delta <= 0) return result;
  result.delta = delta.convert_to<std::uint32_t>();
  result.beyond_max = delta > unit.delta_limit(sight);
  if (result.beyond_max || unit.exceeds_margin(delta, item)) result.state = VoxelState::Shadow;
  return result;
}

}  // namespace gnomon::exact
