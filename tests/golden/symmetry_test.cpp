// SPDX-License-Identifier: Apache-2.0
// Changes of the scene that must not change the answers, to the bit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <gnomon/golden/stream.hpp>
#include <map>
#include <string>
#include <utility>

#include "tests/golden/cases.hpp"
#include "tests/golden/run_stream.hpp"

namespace gnomon::golden_test {
namespace {

using golden::Register;
using golden::VoxelItem;
using golden::Word;

constexpr std::array kRows{Register::MatrixUx, Register::MatrixVx, Register::MatrixDx};

std::size_t at(Register row, std::size_t column) {
  return static_cast<std::size_t>(row) + column;
}

/// A scene whose normals and coefficients can be negated.
Case symmetric_case(std::uint64_t seed) {
  Case c = any_case(seed, Content::Scene, 60);
  const std::int32_t lowest = -(1 << (c.config.normal_bits - 1));
  for (VoxelItem& item : c.items) {
    for (auto& n : item.normal) n = std::max(n, lowest + 1);
  }
  for (const Register row : kRows) {
    for (std::size_t column = 0; column < 3; ++column) {
      const auto reg = static_cast<Register>(at(row, column));
      c.registers[at(row, column)] =
          std::max(c.registers[at(row, column)], stimulus::register_min(reg, c.config) + 1);
    }
  }
  return c;
}

Outcome run_case(const Case& c, bool two_sided) {
  golden::StreamWriter writer(c.config);
  writer.set_registers(Register::MatrixUx, c.registers);
  writer.project(std::span(c.items).first(c.items.size() / 2));
  if (c.config.en_vpu_offset) writer.resolve(c.items, two_sided);
  writer.fence(0, false);
  return run(c.config, writer.words());
}

bool fits(const Case& c, Register reg) {
  const std::int64_t value = c.registers[static_cast<std::size_t>(reg)];
  return value >= stimulus::register_min(reg, c.config) && value <= stimulus::register_max(reg, c.config);
}

/// The properties below would hold trivially if all cases fell off the plane or never met another voxel.
TEST(Symmetry, CasesReachTheOffsetTest) {
  std::map<std::string, std::uint64_t> events;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (const auto& [name, count] : run_case(symmetric_case(seed), false).events) events[name] += count;
  }
  EXPECT_GT(events["PLANE_WRITES"], 1000u);
  EXPECT_GT(events["RESOLVED_UNCERTAIN"], 300u);
  EXPECT_GT(events["RESOLVED_SHADOW"], events["RESOLVED_FACING_AWAY"] + 100);
}

RC_GTEST_PROP(Symmetry, PermutingAxesWithMatrixColumns, (std::uint64_t seed)) {
  const Case c = symmetric_case(seed);
  const Outcome expected = run_case(c, seed % 2 == 0);
  for (const auto& order :
       {std::array<std::size_t, 3>{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}}) {
    Case turned = c;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Register row : kRows) turned.registers[at(row, axis)] = c.registers[at(row, order[axis])];
      for (std::size_t i = 0; i < c.items.size(); ++i) {
        turned.items[i].position[axis] = c.items[i].position[order[axis]];
        turned.items[i].normal[axis] = c.items[i].normal[order[axis]];
      }
    }
    RC_ASSERT(run_case(turned, seed % 2 == 0) == expected);
  }
}

RC_GTEST_PROP(Symmetry, MirroringAnAxis, (std::uint64_t seed)) {
  const Case c = symmetric_case(seed);
  const Outcome expected = run_case(c, seed % 2 == 0);
  const std::uint32_t far = (1u << c.config.position_bits()) - 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Case mirrored = c;
    for (const Register row : kRows) {
      mirrored.registers[at(row, 3)] += c.registers[at(row, axis)] * far;
      mirrored.registers[at(row, axis)] = -c.registers[at(row, axis)];
      RC_PRE(fits(mirrored, static_cast<Register>(at(row, 3))));
    }
    for (VoxelItem& item : mirrored.items) {
      item.position[axis] = far - item.position[axis];
      item.normal[axis] = -item.normal[axis];
    }
    RC_ASSERT(run_case(mirrored, seed % 2 == 0) == expected);
  }
}

RC_GTEST_PROP(Symmetry, SwappingRowsTransposesThePlane, (std::uint64_t seed)) {
  const Case c = symmetric_case(seed);
  Case swapped = c;
  for (std::size_t column = 0; column < 4; ++column) {
    std::swap(swapped.registers[at(Register::MatrixUx, column)],
              swapped.registers[at(Register::MatrixVx, column)]);
  }
  const Outcome a = run_case(c, false), b = run_case(swapped, false);
  RC_ASSERT(a.results == b.results);
  RC_ASSERT(a.events == b.events);
  const auto side = static_cast<std::size_t>(c.config.plane_side());
  for (std::size_t v = 0; v < side; ++v) {
    for (std::size_t u = 0; u < side; ++u) RC_ASSERT(a.plane[v * side + u] == b.plane[u * side + v]);
  }
}

/// With the two-sided flag a surface has no inside.
RC_GTEST_PROP(Symmetry, NegatedNormalsOfATwoSidedSurface, (std::uint64_t seed)) {
  const Case c = symmetric_case(seed);
  Case negated = c;
  for (VoxelItem& item : negated.items) {
    for (auto& n : item.normal) n = -n;
  }
  RC_ASSERT(run_case(c, true) == run_case(negated, true));
}

/// Moving everything by whole codes moves depths and leaves differences.
RC_GTEST_PROP(Symmetry, ShiftingDepthByWholeCodes, (std::uint64_t seed)) {
  const Case c = symmetric_case(seed);
  Case shifted = c;
  const std::int64_t codes = static_cast<std::int64_t>(seed % 9) - 4;
  shifted.registers[at(Register::MatrixDx, 3)] += codes << (c.config.position_bits() + 4);
  RC_PRE(fits(shifted, Register::MatrixD1));
  const golden::Vpu vpu = make_vpu(c.config, c.registers), moved = make_vpu(c.config, shifted.registers);
  for (const VoxelItem& item :
       c.items) {  // nothing may saturate, neither a voxel nor its offset point of either sign
    for (const golden::Vpu& unit : {vpu, moved}) {
      const auto acc = unit.accumulate(item);
      auto g = unit.gradient(item);
      RC_PRE(!unit.land(acc).saturated && !unit.land_offset(acc, g).saturated);
      g = {.u = -g.u, .v = -g.v, .d = -g.d};
      RC_PRE(!unit.land_offset(acc, g).saturated);
    }
  }
  const Outcome a = run_case(c, false), b = run_case(shifted, false);
  RC_ASSERT(a.events == b.events);
  for (std::size_t i = 0; i < a.plane.size(); ++i) {
    RC_ASSERT(b.plane[i] == (a.plane[i] == golden::kEmpty ? golden::kEmpty
                                                          : static_cast<std::uint32_t>(a.plane[i] + codes)));
  }
  for (std::size_t i = 0; i + 1 < a.results.size(); ++i) {
    auto result = golden::decode_voxel_result(a.results[i]);
    if (result.nearest != 0xFFFFFF) result.nearest = static_cast<std::uint32_t>(result.nearest + codes);
    RC_ASSERT(golden::encode(result) == b.results[i]);
  }
}

}  // namespace
}  // namespace gnomon::golden_test
