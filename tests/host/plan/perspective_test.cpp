// SPDX-License-Identifier: Apache-2.0
// Spots and point lights from plan to states: registers say what the projection in double says, and shadows
// are those of the closed form and of exact rays.
#include <gtest/gtest.h>

#include <cmath>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/perspective/view.hpp>

#include "cages.hpp"
#include "host/metrics/shadow_error.hpp"
#include "host/metrics/shadow_truth.hpp"
#include "host/plan/representative.hpp"
#include "host/plan/topology_double.hpp"
#include "host/voxel/voxelizer.hpp"
#include "tests/host/plan/analytic_voxels.hpp"

namespace gnomon::plan {
namespace {

using golden::VoxelState;

const test::Ball kBall{{48, 46, 40}, 16};
const voxel::VoxelSet& ball_scene() {
  static const auto set = test::ball_on_ground(96, kBall, 8.5);
  return set;
}

struct Case {
  LightView view;
  ViewVoxels seen;
  VpuPlan plan;
};
Case make_case(const LightView& view, const VpuSettings& settings = {}) {
  Case made{view, view_voxels(view, ball_scene(), ObjectRoles::all({false, true})), {}};
  made.plan = plan_vpu(ball_scene(), view, made.seen, settings).value();
  return made;
}
std::vector<LightView> some_views() {
  std::vector<LightView> views;
  for (const Light& light : {Light(SpotLight{{48, 46, 90}, Vec3(0, 0, -1), 40}),
                             Light(SpotLight{{-60, 10, 130}, Vec3(0.6, 0.2, -0.7).normalized(), 25}),
                             Light(PointLight{{20, 30, 80}})})
    for (const LightView& view : light_views(light, ball_scene())) views.push_back(view);
  return views;
}

TEST(Perspective, RegistersSeeWhatTheProjectionInDoubleSees) {
  int compared = 0;
  for (const LightView& view : some_views()) {
    const Case c = make_case(view);
    const auto& m = c.plan.registers;
    const auto at = [&](golden::Register reg) { return m.at(static_cast<std::size_t>(reg)); };
    golden::perspective::Registers registers;
    for (std::size_t i = 0; i < 4; ++i) registers.w[i] = m[19 + i];
    registers.centre = {at(golden::Register::CentreU), at(golden::Register::CentreV)};
    registers.key_limit = at(golden::Register::KeyLimit);
    registers.key_scale = at(golden::Register::KeyScale);
    const golden::HardwareConfig& h = c.plan.config;
    const golden::perspective::View unit({h.position_bits(), h.matrix_frac_bits, h.depth_bits, h.plane_log2},
                                         registers);
    for (const std::uint32_t i : c.seen.receivers) {
      const golden::VoxelItem item = voxel_item(ball_scene().voxels[i], h);
      const auto row = [&](std::size_t first) {
        std::int64_t sum = m[first + 3];
        for (std::size_t axis = 0; axis < 3; ++axis) sum += m[first + axis] * item.position[axis];
        return sum;
      };
      const Vec3 p = (Vec3(item.position[0], item.position[1], item.position[2]) + Vec3(0.5)) *
                     std::ldexp(1.0, -h.voxel_frac_bits);
      const auto sight = unit.see(row(0), row(4), item.position);
      ASSERT_FALSE(sight.behind);
      const Vec2 entry = c.plan.projection.entry(p);
      ASSERT_NEAR(std::ldexp(static_cast<double>(sight.u_fine), -12), entry.x, 0.01) << view.name();
      ASSERT_NEAR(std::ldexp(static_cast<double>(sight.v_fine), -12), entry.y, 0.01);
      ASSERT_NEAR(std::ldexp(static_cast<double>(sight.key), -4), c.plan.projection.depth(p), 4);
      ASSERT_TRUE(entry.x > 0 && entry.y > 0 && entry.x < h.plane_side() && entry.y < h.plane_side());
      ++compared;
    }
  }
  EXPECT_GT(compared, 10000);
}

/// A few receivers far off the axis, together: the plane is small, and the axis lies outside of it.
TEST(Perspective, ReceiversFarOffTheAxisAreOnThePlane) {
  int compared = 0, planes = 0;
  for (const bool negative : {false, true}) {
    const double sign = negative ? -1 : 1;
    const PointLight light{{48 - sign * 150, 40 - sign * 140, 20}};
    for (const LightView& view : light_views(light, ball_scene())) {
      ViewVoxels seen = view_voxels(view, ball_scene(), ObjectRoles::all({false, true}));
      std::erase_if(seen.receivers, [&](std::uint32_t i) {
        const Vec3 p = representative(ball_scene().voxels[i]);
        return p.x < 44 || p.x > 52 || p.y < 40 || p.y > 48;
      });
      if (seen.receivers.empty()) continue;
      for (const int plane_log2 : {0, 5}) {
        VpuSettings settings;
        settings.plane_log2 = plane_log2;
        const VpuPlan plan = plan_vpu(ball_scene(), view, seen, settings).value();
        const double side = plan.config.plane_side();
        EXPECT_LT(std::max(std::abs(plan.projection.centre.x), std::abs(plan.projection.centre.y)), 2 * side);
        for (const std::uint32_t i : seen.receivers) {
          const Vec2 at = plan.projection.entry(representative(ball_scene().voxels[i]));
          ASSERT_TRUE(at.x > 0 && at.y > 0 && at.x < side && at.y < side) << at.x << " " << at.y;
          ++compared;
        }
        ++planes;
      }
    }
  }
  EXPECT_GE(planes, 4);
  EXPECT_GT(compared, 400);
}

/// The closed form: whether the way from p to the light meets the ball, and how far from doing otherwise.
bool in_ball_shadow(const Vec3& p, const Vec3& eye, double& from_border) {
  const Vec3 way = (p - eye).normalized();
  const Vec3 to_centre = kBall.centre - p;
  from_border = std::abs((to_centre - way * to_centre.dot(way)).length() - kBall.radius);
  return -to_centre.dot(way) > 0 && (to_centre - way * to_centre.dot(way)).length() < kBall.radius;
}

TEST(Perspective, BallOnGroundAgreesWithTheClosedForm) {
  int compared = 0, wrong_fixed = 0, wrong_double = 0, shadows = 0;
  for (const LightView& view : some_views()) {
    const Case c = make_case(view);
    golden::StreamWriter writer(c.plan.config);
    write_vpu(writer, c.plan.config, c.plan, ball_scene(), c.seen, {false, true});
    writer.fence(0, true);
    const auto engine = golden::make_golden_engine(c.plan.config);
    engine->submit(writer.words());
    std::vector<golden::Word> words;
    engine->drain(
        [&](std::span<const golden::Word> part) { words.insert(words.end(), part.begin(), part.end()); });
    const auto fixed = voxel_results(words, c.seen.receivers.size()).value();
    const auto exact = offset_states_double(c.plan, ball_scene(), c.seen, {false, true});
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      const voxel::Voxel& v = ball_scene().voxels[c.seen.receivers[i]];
      const Vec3 p = representative(v);
      const Vec3 n(double{v.normal[0]}, double{v.normal[1]}, double{v.normal[2]});
      const double facing = -n.dot((p - c.view.eye).normalized());
      double from_border = 0;
      const bool cast = in_ball_shadow(p, c.view.eye, from_border);
      if (v.object == 0 ? std::abs(facing) * kBall.radius < 2.5 : from_border < 3) continue;
      const bool shadow = v.object == 0 ? facing <= 0 : cast;
      ++compared;
      shadows += shadow ? 1 : 0;
      wrong_fixed += (fixed[i].state == VoxelState::Shadow) != shadow ? 1 : 0;
      wrong_double += (exact[i] == VoxelState::Shadow) != shadow ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(shadows, 2000);
  EXPECT_LE(wrong_fixed, compared / 200);
  EXPECT_LE(wrong_double, compared / 200);
}

TEST(Perspective, WhatAConeDoesNotReachIsUnlit) {
  // The hardware is asked about everything here, also outside the cone and behind the light.
  LightView view = light_views(SpotLight{{48, 46, 62}, Vec3(0, 0, -1), 20}, ball_scene()).front();
  Case c = make_case(view);
  const ViewVoxels everything = all_voxels(ball_scene());
  golden::StreamWriter writer(c.plan.config);
  write_vpu(writer, c.plan.config, c.plan, ball_scene(), everything, {false, true});
  const auto engine = golden::make_golden_engine(c.plan.config);
  engine->submit(writer.words());
  std::vector<golden::Word> words;
  engine->drain(
      [&](std::span<const golden::Word> part) { words.insert(words.end(), part.begin(), part.end()); });
  const auto results = voxel_results(words, ball_scene().voxels.size()).value();
  int unlike = 0, unreached = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool out = results[i].outside_cone || results[i].behind;
    unlike += out == view.answers(representative(ball_scene().voxels[i])) ? 1 : 0;
    unreached += out ? 1 : 0;
    EXPECT_TRUE(!out || results[i].state == VoxelState::Shadow);
  }
  EXPECT_GT(unreached, 1000);
  EXPECT_LE(unlike, 20) << "at the edge, by rounding";
}

TEST(Perspective, ALightFarAwayIsRefusedClearly) {
  const auto view = light_views(SpotLight{{48, 46, 1e7}, Vec3(0, 0, -1), 20}, ball_scene()).front();
  const auto plan = plan_vpu(ball_scene(), view, all_voxels(ball_scene()), {});
  ASSERT_FALSE(plan);
  EXPECT_NE(plan.error().message.find("too far"), std::string::npos) << plan.error().message;
}

/// A round body over a wavy sheet under lights that have a place.
TEST(Perspective, TopologyAgreesWithExactRays) {
  std::vector<surface::LimitSurface> surfaces;
  const Mat4 up = Mat4().setScale(14.0) * Mat4().setTranslation(Vec3(32, 32, 42));
  const Mat4 down = Mat4().setScale(Vec3(54, 54, 6)) * Mat4().setTranslation(Vec3(5, 5, 12));
  surfaces.push_back(std::move(*surface::LimitSurface::build(test::torus(5, 4), up)));
  surfaces.push_back(std::move(*surface::LimitSurface::build(test::sheet(4, 3), down)));
  voxel::Grid grid;
  grid.res = 64;
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  const voxel::VoxelSet voxels = voxel::voxelize(surfaces, grid, options).value();
  const auto casting = voxel::casting_quads(surfaces, voxels);
  const auto limit = voxel::limit_quads(surfaces, voxels);
  const std::vector<bool> two_sided{false, true};
  for (const Light& light :
       {Light(SpotLight{{32, 20, 90}, Vec3(0, 0.2, -1).normalized(), 35}), Light(PointLight{{14, 25, 58}})}) {
    const metrics::ExactReference reference(surfaces, two_sided, light);
    const auto truth = metrics::shadow_truth(reference, surfaces, voxels);
    std::uint64_t asked = 0, wrong = 0, wrong_double = 0, fallbacks = 0;
    for (const LightView& view : light_views(light, voxels)) {
      const ViewVoxels seen = view_voxels(view, voxels, ObjectRoles::all(two_sided));
      const auto plan = plan_topology(voxels, casting.quads, view, seen, {}).value();
      golden::StreamWriter writer(plan.vpu.config);
      write_topology(writer, plan.vpu.config, plan, voxels, seen.receivers, two_sided);
      const auto engine = golden::make_golden_engine(plan.vpu.config);
      engine->submit(writer.words());
      std::vector<golden::Word> words;
      engine->drain(
          [&](std::span<const golden::Word> part) { words.insert(words.end(), part.begin(), part.end()); });
      const auto results = topology_results(words, seen.receivers.size()).value();
      const auto exact = topology_states_double(plan, voxels, limit, seen.receivers, two_sided).states;
      fallbacks += engine->counters().events.at("TOPOLOGY_FALLBACK");
      for (std::size_t i = 0; i < results.size(); ++i) {
        const std::uint32_t voxel = seen.receivers[i];
        if (truth.unambiguous[voxel] == 0) continue;
        const bool shadow = metrics::in_shadow(truth.voxels[voxel]);
        ++asked;
        wrong += results[i].shadow != shadow ? 1U : 0U;
        wrong_double += (exact[i] == VoxelState::Shadow) != shadow ? 1U : 0U;
      }
    }
    EXPECT_GT(asked, 2000U);
    EXPECT_LE(wrong, asked / 1000);
    EXPECT_LE(wrong_double, asked / 5000);
    EXPECT_EQ(fallbacks, 0U);
  }
}

}  // namespace
}  // namespace gnomon::plan
