// SPDX-License-Identifier: Apache-2.0
// One function a pattern.
#include "tests/support/voxel_patterns.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::VoxelItem;

using Vector = std::array<std::int64_t, 3>;

class Maker {
 public:
  Maker(const RegisterValues& registers, const HardwareConfig& config, Random& random)
      : random_(random),
        position_max_((std::int64_t{1} << config.position_bits()) - 1),
        normal_max_((std::int64_t{1} << (config.normal_bits - 1)) - 1) {
    const auto depth = static_cast<std::size_t>(golden::Register::MatrixDx);
    for (std::size_t i = 0; i < 3; ++i) depth_row_[i] = registers[depth + i];
  }

  Vector any_position() {
    Vector p;
    for (auto& c : p) c = random_.between(0, position_max_);
    return p;
  }
  Vector any_normal() {
    Vector n;
    for (auto& c : n) c = random_.between(-normal_max_ - 1, normal_max_);
    return n;
  }
  /// A normal that looks against the light.
  Vector facing_normal() {
    Vector n = any_normal();
    if (slope(n) > 0) {
      for (auto& c : n) c = std::max(-c, -normal_max_ - 1);
    }
    return n;
  }
  /// The flattest of some normals: nearly across the light.
  Vector grazing_normal() {
    Vector best = any_normal();
    for (int i = 0; i < 12; ++i) {
      const Vector n = any_normal();
      if (std::abs(slope(n)) < std::abs(slope(best))) best = n;
    }
    return random_.chance(10) ? Vector{} : best;
  }
  Vector corner_position() {
    Vector p;
    for (auto& c : p) c = end(0, position_max_);
    return p;
  }
  Vector corner_normal() {
    Vector n;
    for (auto& c : n) c = random_.chance(20) ? 0 : end(-normal_max_ - 1, normal_max_);
    return n;
  }
  /// `position` moved by about `steps` ulps along the light.
  Vector along_light(const Vector& position, std::int64_t steps) const {
    std::int64_t largest = 1;
    for (const auto c : depth_row_) largest = std::max(largest, std::abs(c));
    Vector p = position;
    for (std::size_t i = 0; i < 3; ++i) p[i] += depth_row_[i] * steps / largest;
    return p;
  }

  /// The item, position and normal cut to what an item can hold.
  VoxelItem item(const Vector& position, const Vector& normal) const {
    VoxelItem voxel;
    for (std::size_t i = 0; i < 3; ++i) {
      voxel.position[i] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(position[i], 0, position_max_));
      voxel.normal[i] =
          static_cast<std::int32_t>(std::clamp<std::int64_t>(normal[i], -normal_max_ - 1, normal_max_));
    }
    return voxel;
  }

  Random& random() { return random_; }
  std::int64_t position_max() const { return position_max_; }

 private:
  /// Depth gained along the normal. Saturation of extreme registers cannot happen: widths are below 48 bits.
  std::int64_t slope(const Vector& n) const {
    return depth_row_[0] * n[0] + depth_row_[1] * n[1] + depth_row_[2] * n[2];
  }
  std::int64_t end(std::int64_t low, std::int64_t high) {
    const std::array<std::int64_t, 4> ends{low, high, low + 1, high - 1};
    return random_.pick(std::span<const std::int64_t>(ends));
  }

  Random& random_;
  std::int64_t position_max_, normal_max_;
  Vector depth_row_{};
};

using Items = std::vector<VoxelItem>;

void add_columns(Items& items, std::size_t count, Maker& make) {
  while (items.size() < count) {
    const Vector base = make.any_position();
    const std::int64_t height = make.random().between(2, 8);
    const std::int64_t step = make.random().between(1, std::max<std::int64_t>(1, make.position_max() / 16));
    for (std::int64_t i = 0; i < height && items.size() < count; ++i) {
      const std::int64_t jitter = make.random().between(0, step);
      items.push_back(make.item(make.along_light(base, i * step - jitter), make.facing_normal()));
    }
  }
}

void add_burst(Items& items, std::size_t count, Maker& make) {
  std::vector<Vector> bases(static_cast<std::size_t>(make.random().between(1, 5)));
  for (auto& base : bases) base = make.any_position();
  for (std::size_t i = 0; items.size() < count; ++i) {
    const Vector& base = bases[make.random().chance(80) ? i % bases.size() : 0];
    const std::int64_t steps = make.random().between(-4, 4);
    items.push_back(make.item(make.along_light(base, steps), make.facing_normal()));
  }
}

void add_ties(Items& items, std::size_t count, Maker& make) {
  std::vector<Vector> bases(static_cast<std::size_t>(make.random().between(1, 8)));
  for (auto& base : bases) base = make.any_position();
  while (items.size() < count) {
    const Vector& base = make.random().pick(std::span<const Vector>(bases));
    items.push_back(make.item(base, make.any_normal()));
  }
}

void add_sheet(Items& items, std::size_t count, Maker& make) {
  const Vector normal = make.facing_normal();
  const Vector base = make.any_position();
  const std::int64_t tilt_x = make.random().between(-3, 3), tilt_y = make.random().between(-3, 3);
  const std::int64_t row = make.random().between(4, 40);
  for (std::int64_t i = 0; items.size() < count; ++i) {
    const std::int64_t x = i % row, y = i / row;
    items.push_back(make.item({base[0] + x, base[1] + y, base[2] + (tilt_x * x + tilt_y * y) / 2}, normal));
  }
}

}  // namespace

std::vector<VoxelItem> voxel_pattern(Pattern pattern, std::size_t count, const RegisterValues& registers,
                                     const HardwareConfig& config, Random& random) {
  Maker make(registers, config, random);
  Items items;
  items.reserve(count);
  switch (pattern) {
    case Pattern::Columns:
      add_columns(items, count, make);
      break;
    case Pattern::Burst:
      add_burst(items, count, make);
      break;
    case Pattern::Ties:
      add_ties(items, count, make);
      break;
    case Pattern::Sheet:
      add_sheet(items, count, make);
      break;
    case Pattern::Uniform:
    case Pattern::Corners:
    case Pattern::Grazing:
      break;  // one independent item after the other, below
  }
  while (items.size() < count) {
    const bool corner = pattern == Pattern::Corners;
    const Vector position = corner ? make.corner_position() : make.any_position();
    const Vector normal = corner                        ? make.corner_normal()
                          : pattern == Pattern::Grazing ? make.grazing_normal()
                                                        : make.any_normal();
    items.push_back(make.item(position, normal));
  }
  return items;
}

}  // namespace gnomon::stimulus
