// SPDX-License-Identifier: Apache-2.0
// Scene to states on the golden engine: against the closed form, against the method in double, and result
// checks.
#include <gtest/gtest.h>

#include <cmath>
#include <gnomon/golden/golden_engine.hpp>

#include "host/plan/vpu_plan.hpp"
#include "tests/host/plan/analytic_voxels.hpp"

namespace gnomon::plan {
namespace {

const test::Ball kBall{{48, 46, 52}, 22};

struct States {
  voxel::VoxelSet voxels;
  VpuPlan plan;
  std::vector<golden::Word> results;
  std::vector<golden::VoxelResult> fixed;
  std::vector<golden::VoxelState> exact_method;
};

States shadow_states(const Vec3& light, const VpuSettings& settings) {
  States s{test::ball_on_ground(96, kBall, 8.5), {}, {}, {}, {}};
  s.plan = plan_vpu(s.voxels, light, settings).value();
  const std::vector<bool> two_sided{false, true};
  const auto engine = golden::make_golden_engine(s.plan.config);
  engine->submit(vpu_stream(s.plan, s.voxels, two_sided));
  engine->drain([&](std::span<const golden::Word> words) {
    s.results.insert(s.results.end(), words.begin(), words.end());
  });
  s.fixed = voxel_results(s.results, s.voxels.voxels.size()).value();
  s.exact_method = offset_states_double(s.plan, s.voxels, all_voxels(s.voxels), two_sided);
  return s;
}

/// Voxels whose state differs from the closed form, left out those within `band` voxels of a shadow border.
struct Count {
  int compared = 0, wrong = 0;
};
template <class StateOf>
Count against_closed_form(const States& s, const Vec3& light, double band, StateOf&& state_of) {
  Count count;
  const Vec3 l = light.normalized();
  for (std::size_t i = 0; i < s.voxels.voxels.size(); ++i) {
    const auto& v = s.voxels.voxels[i];
    const Vec3 p(v.x + double{v.point[0]}, v.y + double{v.point[1]}, v.z + double{v.point[2]});
    const Vec3 n(double{v.normal[0]}, double{v.normal[1]}, double{v.normal[2]});
    const Vec3 to_axis = p - kBall.centre;
    const double from_border = std::abs((to_axis - l * to_axis.dot(l)).length() - kBall.radius);
    const bool terminator = v.object == 0 && std::abs(n.dot(l)) * kBall.radius < band;
    if (terminator || (v.object == 1 && from_border < band)) continue;
    const bool shadow = v.object == 0 ? n.dot(l) >= 0 : test::in_shadow_of(kBall, p, l);
    ++count.compared;
    count.wrong += (state_of(i) == golden::VoxelState::Shadow) != shadow;
  }
  return count;
}

TEST(States, BallOnGroundAgreesWithTheClosedForm) {
  for (const Vec3& light : {Vec3(0, 0, -1), Vec3(-0.4, 0.3, -1), Vec3(0.9, 0.2, -0.6)}) {
    const auto s = shadow_states(light, {});
    const auto fixed = against_closed_form(s, light, 2.5, [&](std::size_t i) { return s.fixed[i].state; });
    const auto method = against_closed_form(s, light, 2.5, [&](std::size_t i) { return s.exact_method[i]; });
    EXPECT_GT(fixed.compared, 8000);
    EXPECT_LE(fixed.wrong, fixed.compared / 200) << light;
    EXPECT_LE(method.wrong, method.compared / 200) << light;
  }
}

TEST(States, TheClosedFormSeesAWrongLight) {
  const auto s = shadow_states({-0.4, 0.3, -1}, {});
  const auto wrong =
      against_closed_form(s, {0.4, 0.3, -1}, 2.5, [&](std::size_t i) { return s.fixed[i].state; });
  EXPECT_GT(wrong.wrong, wrong.compared / 50);
}

TEST(States, QuantisationChangesFewAnswers) {
  for (const Vec3& light : {Vec3(0, 0, -1), Vec3(-0.4, 0.3, -1), Vec3(0.9, 0.2, -0.3)}) {
    VpuSettings settings;
    settings.voxel_frac_bits = 4;
    const auto s = shadow_states(light, settings);
    ASSERT_EQ(s.fixed.size(), s.exact_method.size());
    std::size_t differing = 0;
    for (std::size_t i = 0; i < s.fixed.size(); ++i) differing += s.fixed[i].state != s.exact_method[i];
    EXPECT_LT(differing, s.fixed.size() / 100) << light;
  }
}

TEST(VoxelResults, CountsAndRefuses) {
  const auto s = shadow_states({0, 0, -1}, {});
  const std::size_t n = s.fixed.size();
  EXPECT_EQ(s.results.size(), n + 1);  // and the fence
  EXPECT_FALSE(voxel_results(s.results, n + 1));
  EXPECT_FALSE(voxel_results(std::span(s.results).first(n - 1), n));
  auto with_error = s.results;
  with_error[n / 2] = golden::encode(golden::ErrorResult{3, 7});
  const auto refused = voxel_results(with_error, n);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("refused"), std::string::npos);
}

}  // namespace
}  // namespace gnomon::plan
