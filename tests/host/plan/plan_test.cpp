// SPDX-License-Identifier: Apache-2.0
// The planner: registers fit and say what the projection in double says; wishes that cannot be met are
// refused by name.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "host/plan/vpu_plan.hpp"
#include "tests/host/plan/analytic_voxels.hpp"

namespace gnomon::plan {
namespace {

const test::Ball kBall{{32, 30, 36}, 15};
const voxel::VoxelSet& scene() {
  static const auto set = test::ball_on_ground(64, kBall, 4.5);
  return set;
}

const std::vector<Vec3> kLights{{0, 0, -1}, {1, 0, 0},        {-0.3, 0.5, -1},   {0.7, -0.2, -0.1},
                                {3, 4, -5}, {1e-9, 0, -1e-6}, {0.001, 1, -0.001}};

std::int64_t reg(const VpuPlan& plan, golden::Register index) {
  return plan.registers.at(static_cast<std::size_t>(index));
}

TEST(PlanVpu, EveryRegisterFitsItsWidth) {
  int compared = 0;
  for (const auto& light : kLights)
    for (const int depth_bits : {8, 16, 24})
      for (const double pitch : {0.5, 1.0, 3.0})
        for (const double tan_max : {1.0, 10.0, 100.0}) {
          VpuSettings settings;
          settings.depth_bits = depth_bits;
          settings.pitch = pitch;
          settings.margin_tan_max = tan_max;
          const auto plan = plan_vpu(scene(), light, settings);
          ASSERT_TRUE(plan) << plan.error().message;
          ASSERT_EQ(plan->registers.size(), static_cast<std::size_t>(golden::kRegisterCount));
          for (int index = 0; index < golden::kRegisterCount; ++index) {
            const auto format = golden::register_format(static_cast<golden::Register>(index), plan->config);
            const double limit = std::ldexp(1.0, format.width - (format.is_signed ? 1 : 0));
            const auto value = static_cast<double>(plan->registers[static_cast<std::size_t>(index)]);
            EXPECT_LT(value, limit) << format.name;
            EXPECT_GE(value, format.is_signed ? -limit : 0.0) << format.name;
            ++compared;
          }
        }
  EXPECT_EQ(compared, 7 * 3 * 3 * 3 * golden::kRegisterCount);
}

TEST(PlanVpu, RegistersProjectWithinTheirBound) {
  for (const auto& light : kLights) {
    const auto plan = plan_vpu(scene(), light, {});
    ASSERT_TRUE(plan) << plan.error().message;
    const int f = plan->config.matrix_frac_bits;
    const int p_bits = plan->config.position_bits();
    const double entry_bound = (3 * std::ldexp(1.0, p_bits) + 1) * std::ldexp(1.0, -f - 1);
    const double depth_bound = (3 * std::ldexp(1.0, p_bits) + 1) * std::ldexp(1.0, -p_bits - 5);
    const auto row = [&](golden::Register first, int frac, const golden::VoxelItem& item) {
      const auto base = static_cast<std::size_t>(first);
      double sum = static_cast<double>(plan->registers[base + 3]);
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum += static_cast<double>(plan->registers[base + axis]) * item.position[axis];
      return std::ldexp(sum, -frac);
    };
    for (const auto& item : voxel_items(scene(), plan->config)) {
      const Vec3 p = (Vec3(item.position[0], item.position[1], item.position[2]) + Vec3(0.5)) *
                     std::ldexp(1.0, -plan->config.voxel_frac_bits);
      const Vec2 entry = plan->projection.entry(p);
      ASSERT_NEAR(row(golden::Register::MatrixUx, f, item), entry.x, entry_bound);
      ASSERT_NEAR(row(golden::Register::MatrixVx, f, item), entry.y, entry_bound);
      ASSERT_NEAR(row(golden::Register::MatrixDx, p_bits + 4, item), plan->projection.depth(p), depth_bound);
    }
  }
}

TEST(PlanVpu, VoxelsAndTheirOffsetPointsLandOnThePlane) {
  for (const auto& light : kLights)
    for (const double pitch : {0.5, 1.0, 2.5}) {
      VpuSettings settings;
      settings.pitch = pitch;
      const auto plan = plan_vpu(scene(), light, settings);
      ASSERT_TRUE(plan) << plan.error().message;
      const double side = plan->config.plane_side();
      for (const auto& v : scene().voxels) {
        const Vec3 a(v.x + double{v.point[0]}, v.y + double{v.point[1]}, v.z + double{v.point[2]});
        const Vec3 n(double{v.normal[0]}, double{v.normal[1]}, double{v.normal[2]});
        for (const Vec3& p : {a, a + n * settings.offset_factor}) {
          const Vec2 e = plan->projection.entry(p);
          ASSERT_TRUE(e.x >= 0 && e.y >= 0 && e.x < side && e.y < side) << e.x << ' ' << e.y;
          const double d = plan->projection.depth(p);
          ASSERT_TRUE(d >= 0 && d <= std::ldexp(1.0, plan->config.depth_bits) - 2) << d;
        }
      }
    }
}

TEST(PlanVpu, AxisParallelLightSeesVoxelColumnsAsEntries) {
  VpuSettings settings;
  settings.pitch = 1;
  const auto plan = plan_vpu(scene(), {0, 0, -1}, settings);
  ASSERT_TRUE(plan);
  for (const auto& row : {plan->projection.u, plan->projection.v})
    EXPECT_NEAR(std::abs(row.x) + std::abs(row.y) + std::abs(row.z), 1, 1e-15);
  EXPECT_EQ(plan->projection.u1, std::floor(plan->projection.u1));
  EXPECT_EQ(plan->projection.v1, std::floor(plan->projection.v1));
}

TEST(PlanVpu, AutomaticPlaneIsTheSmallestThatHolds) {
  // 64 voxels and the reach of the offset points.
  for (const auto& [pitch, log2] : {std::pair{1.0, 7}, std::pair{1.4, 6}, std::pair{0.5, 8}}) {
    VpuSettings settings;
    settings.pitch = pitch;
    const auto plan = plan_vpu(scene(), {0, 0, -1}, settings);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->config.plane_log2, log2) << pitch;
  }
}

TEST(PlanVpu, AutomaticWidthsFillTheVoxelWord) {
  for (const auto& [res, frac, normal] : {std::array{64, 4, 9}, std::array{256, 4, 9}, std::array{512, 3, 9},
                                          std::array{1024, 2, 9}, std::array{2048, 1, 9}}) {
    auto set = scene();
    set.grid.res = static_cast<std::uint32_t>(res);
    const auto plan = plan_vpu(set, {0, 0, -1}, {});
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->config.voxel_frac_bits, frac) << res;
    EXPECT_EQ(plan->config.normal_bits, normal) << res;
  }
}

TEST(PlanVpu, PlaneTooSmallForThePitchGetsLargerEntries) {
  VpuSettings settings;
  settings.plane_log2 = 5;
  const auto plan = plan_vpu(scene(), {-0.3, 0.5, -1}, settings);
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->config.plane_log2, 5);
  EXPECT_GT(plan->settings.pitch, 2.0);
  EXPECT_EQ(plan->settings.pitch, plan->projection.pitch);
}

TEST(PlanVpu, MarginZeroIsThePapersLiteralTest) {
  VpuSettings settings;
  settings.margin = 0;
  const auto plan = plan_vpu(scene(), {-0.3, 0.5, -1}, settings);
  ASSERT_TRUE(plan);
  EXPECT_EQ(reg(*plan, golden::Register::MarginSquared), 0);
  EXPECT_EQ(reg(*plan, golden::Register::DeltaMax), 0);
}

TEST(PlanVpu, RefusesWhatCannotBeBuilt) {
  const auto message = [](const voxel::VoxelSet& voxels, const Vec3& light, const VpuSettings& settings) {
    const auto plan = plan_vpu(voxels, light, settings);
    return plan ? std::string("accepted") : plan.error().message;
  };
  VpuSettings wide, offset;
  wide.normal_bits = 12;
  offset.offset_factor = 300;
  EXPECT_NE(message({}, {0, 0, -1}, {}).find("no voxels"), std::string::npos);
  EXPECT_NE(message(scene(), {0, 0, 0}, {}).find("light"), std::string::npos);
  EXPECT_NE(message(scene(), {NAN, 0, 1}, {}).find("light"), std::string::npos);
  EXPECT_NE(message(scene(), {0, 0, -1}, offset).find("offset=300"), std::string::npos);
  wide.voxel_frac_bits = 6;
  EXPECT_NE(message(scene(), {0, 0, -1}, wide).find("NORMAL_BITS"), std::string::npos);
}

}  // namespace
}  // namespace gnomon::plan
