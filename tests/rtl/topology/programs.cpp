// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/topology/programs.hpp"

#include <cmath>

namespace gnomon::rtl_test::topology {

namespace {

using Vector = std::array<double, 3>;

/// Above it a program does not end with a look at all entries: a large plane has millions.
constexpr int kLargestPlaneRead = 7;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

std::uint32_t random_clearance(stimulus::Random& random, const TopologyConfig& config) {
  const int bits = static_cast<int>(random.between(0, config.depth_bits));
  return static_cast<std::uint32_t>(random.between(0, (std::int64_t{1} << bits) - 1));
}

Quad quad_of_any_kind(stimulus::Random& random, const TopologyConfig& config) {
  const int ulps = ulps_per_entry(config);
  Quad quad = test::random_quad(random, config, random.chance(80) ? 2 * ulps : 12 * ulps);
  if (random.chance(5)) quad[2] = quad[1];                      // no area on one side
  if (random.chance(3)) quad[1] = quad[2] = quad[3] = quad[0];  // a point
  return quad;
}

ProjectionRegisters any_light(stimulus::Random& random, const TopologyConfig& config) {
  if (random.chance(15)) return wild_registers(random, config);
  const auto coordinate = [&random] { return static_cast<double>(random.between(-100, 100)) + 0.5; };
  ProjectionRegisters registers = light(config, {coordinate(), coordinate(), coordinate()});
  if (random.chance(30)) registers = light(config, {0, 0, -1});
  if (random.chance(20)) registers.matrix[11] *= random.between(-1, 2);  // depths saturate
  return registers;
}

}  // namespace

Command clear_lists() {
  return {.op = TopologyOp::ClearLists};
}

Command set(const ProjectionRegisters& registers) {
  return {.sets_registers = true, .registers = registers};
}

Command put(std::span<const Quad> quads, const TopologyConfig& config) {
  Command command{.op = TopologyOp::PutQuads};
  for (const Quad& quad : quads)
    for (const Item& corner : quad) command.items.push_back(test::word_of(corner, config));
  return command;
}

Command resolve(std::span<const Item> voxels, const TopologyConfig& config, std::uint8_t flags,
                std::uint32_t clearance) {
  Command command{.op = TopologyOp::ResolveTopology, .flags = flags, .arg = clearance};
  for (const Item& voxel : voxels) command.items.push_back(test::word_of(voxel, config));
  return command;
}

Program read_all(const TopologyConfig& config) {
  const auto entries = static_cast<std::uint32_t>(config.side() * config.side());
  Program program;
  for (std::uint32_t first = 0; first < entries; first += 256)
    program.push_back({.op = TopologyOp::ReadLists, .arg = 255u << 24 | first});
  return program;
}

ProjectionRegisters light(const TopologyConfig& config, const Vector& direction, double entries,
                          double codes) {
  const Vector d = unit(direction);
  const Vector u = unit(cross(d, std::abs(d[2]) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0}));
  const Vector v = cross(d, u);
  const double ulp = 1.0 / (1 << config.voxel_frac_bits), half = 1 << (config.voxel_bits - 1);
  ProjectionRegisters registers;
  const std::array<Vector, 3> rows = {u, v, d};
  for (std::size_t row = 0; row < 3; ++row) {
    const double scale = row < 2 ? std::ldexp(entries, config.matrix_frac_bits)
                                 : std::ldexp(codes, config.position_bits() + 4);
    for (std::size_t i = 0; i < 3; ++i)
      registers.matrix[4 * row + i] = std::llround(rows[row][i] * ulp * scale);
    const double middle = row < 2
                              ? std::ldexp(static_cast<double>(config.side()) / 2, config.matrix_frac_bits)
                              : std::ldexp(1.0, config.depth_bits - 1 + config.position_bits() + 4);
    const double sum = rows[row][0] + rows[row][1] + rows[row][2];
    registers.matrix[4 * row + 3] = std::llround(middle - half * sum * scale);
  }
  registers.offset_factor = std::lround(0.2 / ulp * 65536 / ((1 << (config.normal_bits - 1)) - 1));
  return registers;
}

ProjectionRegisters light(const TopologyConfig& config, const Vector& direction) {
  const double voxels = 1 << config.voxel_bits;
  return light(config, direction, std::min(1.0, static_cast<double>(config.side()) / voxels),
               config.no_depth() / 2.0 / voxels);
}

int ulps_per_entry(const TopologyConfig& config) {
  return (1 << config.voxel_frac_bits) * std::max(1, (1 << config.voxel_bits) >> config.plane_log2);
}

ProjectionRegisters wild_registers(stimulus::Random& random, const TopologyConfig& config) {
  const auto number = [&](int width) {
    const std::int64_t half = std::int64_t{1} << (width - 1);
    return random.chance(10) ? -half : random.between(-half, half - 1);
  };
  const int p = config.position_bits(), f = config.matrix_frac_bits, d = config.depth_bits;
  ProjectionRegisters registers;
  for (std::size_t i = 0; i < 12; ++i) {
    const bool constant = i % 4 == 3;
    if (i < 8)
      registers.matrix[i] = number(constant ? f + p + 3 : f + 2);
    else
      registers.matrix[i] = number(constant ? d + p + 8 : d + p + 2);
  }
  registers.offset_factor = random.between(0, (1 << 18) - 1);
  return registers;
}

Program random_program(stimulus::Random& random, const TopologyConfig& config, int commands) {
  Program program{set(any_light(random, config))};
  for (int i = 0; i < commands; ++i) {
    const int kind = static_cast<int>(random.between(0, 99));
    if (kind < 5) {
      program.push_back(clear_lists());
    } else if (kind < 12) {
      program.push_back(set(any_light(random, config)));
    } else if (kind < 50) {
      std::vector<Quad> quads(static_cast<std::size_t>(random.between(0, 40)));
      for (Quad& quad : quads) quad = quad_of_any_kind(random, config);
      program.push_back(put(quads, config));
    } else if (kind < 95) {
      std::vector<Item> voxels(static_cast<std::size_t>(random.between(0, 60)));
      for (Item& voxel : voxels) voxel = test::random_item(random, config);
      program.push_back(resolve(voxels, config, static_cast<std::uint8_t>(random.between(0, 3)),
                                random_clearance(random, config)));
    } else {
      const std::int64_t entries = config.side() * config.side();
      const std::int64_t count = random.between(1, std::min<std::int64_t>(entries, 256));
      const auto first = static_cast<std::uint32_t>(random.between(0, entries - count));
      program.push_back(
          {.op = TopologyOp::ReadLists, .arg = static_cast<std::uint32_t>(count - 1) << 24 | first});
    }
  }
  if (config.plane_log2 <= kLargestPlaneRead)
    for (Command& command : read_all(config)) program.push_back(command);
  return program;
}

}  // namespace gnomon::rtl_test::topology
