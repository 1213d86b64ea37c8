// SPDX-License-Identifier: Apache-2.0
// What casts, where the plane lies, which words say so.
#include "host/plan/slb_plan.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "host/plan/slb_stream.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::plan {
namespace {

using golden::slb::SlbOp;
using testing::HasSubstr;

/// A box over a sheet.
class SlbPlanTest : public testing::Test {
 protected:
  SlbPlanTest()
      : surfaces_(fixtures::surfaces(
            {fixtures::box({20, 20, 6.5}, {34, 30, 20}, true), fixtures::sheet(3, 3, 61, 61, 6.5, 4, 4)})),
        voxels_(fixtures::voxels(surfaces_, 64)) {}

  SlbPlan plan(const Vec3& light, const SlbSettings& settings = {}) const {
    auto made = plan_slb(voxels_, {true, true}, light, settings);
    if (!made) throw std::runtime_error(made.error().message);
    return *made;
  }
  /// The items of all commands with this op.
  static std::vector<golden::Word> items(const golden::StreamWriter& writer, SlbOp op) {
    std::vector<golden::Word> all;
    golden::CommandReader reader(writer.words());
    while (const auto command = reader.next()) {
      if (command->header.op == static_cast<std::uint8_t>(op))
        all.insert(all.end(), command->items.begin(), command->items.end());
    }
    return all;
  }

  std::vector<surface::LimitSurface> surfaces_;
  voxel::VoxelSet voxels_;
};

TEST_F(SlbPlanTest, AFlatGroundCastsNothingUnlessTheLightComesFromBelow) {
  EXPECT_THAT(plan({0.3, 0.1, -1}).casts, testing::ElementsAre(true, false));
  EXPECT_THAT(plan({0.3, 0.1, 1}).casts, testing::ElementsAre(true, true));
  const auto told = plan_slb(voxels_, {true, false}, {0.3, 0.1, 1}, {});
  EXPECT_THAT(told->casts, testing::ElementsAre(true, false)) << "an object may be told not to";
  const auto flat = fixtures::surfaces({fixtures::sheet(3, 3, 61, 61, 6.5, 4, 4)});
  const auto alone = plan_slb(fixtures::voxels(flat, 64), {true}, {0, 0, -1}, {});
  ASSERT_FALSE(alone);
  EXPECT_THAT(alone.error().message, HasSubstr("nothing in the scene can cast a shadow"));
  EXPECT_FALSE(plan_slb(voxels_, {true, true}, {0, 0, 0}, {}));
}

TEST_F(SlbPlanTest, ThePlaneHoldsTheCastersAndIsFilled) {
  SlbSettings settings;
  settings.plane_log2 = 7;
  const SlbPlan made = plan({0.3, 0.1, -1}, settings);
  EXPECT_EQ(made.plane.side, 128);
  Box3 seen;
  for (const voxel::Voxel& v : voxels_.voxels) {
    if (v.object != 0) continue;
    const Vec2 p =
        made.plane.pixel({v.x + double{v.point[0]}, v.y + double{v.point[1]}, v.z + double{v.point[2]}});
    seen.extendBy(Vec3(p.x, p.y, 0));
  }
  EXPECT_GT(std::min(seen.min.x, seen.min.y), 1.0);
  EXPECT_LT(std::max(seen.max.x, seen.max.y), 127.0);
  EXPECT_GT(std::max(seen.size().x, seen.size().y), 126 - 2 / made.plane.pitch - 1e-9);
  EXPECT_LT(plan({0.3, 0.1, -1}).plane.pitch, 1.75);
  EXPECT_GE(plan({0.3, 0.1, -1}).plane.pitch, 1.75 / 2.2);
}

TEST_F(SlbPlanTest, TheOutlinersFrameIsThePlane) {
  const SlbPlan made = plan({0.3, 0.1, -1});
  const Vec3 p(25, 31, 9);
  EXPECT_NEAR(made.frame().pixel(p).x, made.plane.pixel(p).x, 1e-9);
  EXPECT_NEAR(made.frame().pixel(p).y, made.plane.pixel(p).y, 1e-9);
  EXPECT_NEAR(made.frame().code(p), made.code(p), 1e-6);
  for (const voxel::Voxel& v : voxels_.voxels) {
    const double code = made.code({double(v.x), double(v.y), double(v.z)});
    ASSERT_GT(code, 0);
    ASSERT_LT(code, std::ldexp(1.0, 20) - 2);
  }
}

TEST_F(SlbPlanTest, IllegalHardwareIsRefusedByName) {
  SlbSettings settings;
  settings.frac_bits = 9;
  const auto made = plan_slb(voxels_, {true, true}, {0, 0, -1}, settings);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("FRAC_BITS"));
}

TEST_F(SlbPlanTest, OnlyReceiversThatFaceTheLightAreAskedFor) {
  const SlbPlan made = plan({0, 0, -1});
  golden::StreamWriter writer(made.config);
  const std::vector<Receiver> receivers{
      {25, 25, 6.5f, 1}, {25, 25, 6.5f, 1e-10f}, {25, 25, 6.5f, -1}, {900, 25, 6.5f, 1}};
  ask_receivers(writer, made, receivers);
  const std::vector<golden::Word> asked = items(writer, SlbOp::Query);
  ASSERT_EQ(asked.size(), 2u);
  const golden::slb::QueryPoint point = golden::slb::decode_query(asked[0], made.config.slb_config());
  const Vec2 pixel = made.plane.pixel({25, 25, 6.5});
  EXPECT_EQ(point.x, static_cast<std::int64_t>(std::floor(std::ldexp(pixel.x, made.config.query_bits))));
  EXPECT_EQ(point.y, static_cast<std::int64_t>(std::floor(std::ldexp(pixel.y, made.config.query_bits))));
  EXPECT_EQ(point.depth, static_cast<std::uint32_t>(std::floor(made.code({25, 25, 6.5}))));
  const golden::slb::QueryPoint far = golden::slb::decode_query(asked[1], made.config.slb_config());
  const auto outside = [&](std::int64_t x) {
    return x >> made.config.query_bits >= made.plane.side || x < 0;
  };
  EXPECT_TRUE(outside(far.x) || outside(far.y)) << "off the plane stays off the plane";
}

TEST_F(SlbPlanTest, EveryPixelInsideASheetHasASampleThatIsNotNearer) {
  SlbSettings settings;
  settings.plane_log2 = 8;  // pixels a sixteenth of a voxel's face
  const SlbPlan made = plan({0.3, 0.1, -1}, settings);
  const auto outlines = outline::outlines(std::span(surfaces_).first(1), made.frame());
  ASSERT_TRUE(outlines);
  golden::StreamWriter writer(made.config);
  const std::vector<std::vector<golden::slb::CoverSample>> samples{
      cover_samples(made, sheet_samples(made, surfaces_[0], voxels_, 0, false))};
  draw_casters(writer, made, *outlines, samples);
  std::vector<int> of_pixel(std::size_t{256} * 256);
  for (const golden::Word word : items(writer, SlbOp::Cover)) {
    const auto sample = golden::slb::decode_cover(word, made.config.slb_config());
    ++of_pixel.at(static_cast<std::size_t>(sample.row * 256 + sample.column));
  }
  // The box's top: its depth at every pixel is that of its plane there, and one sheet is one sample.
  int inside = 0;
  for (const golden::Word word : items(writer, SlbOp::Cover)) {
    const auto sample = golden::slb::decode_cover(word, made.config.slb_config());
    ASSERT_LE(sample.range, 20u);
  }
  for (int i = 0; i < 1300; ++i)
    for (int j = 0; j < 90; ++j) {
      const double x = 20.5 + 0.01 * i;
      const double y = 20.5 + 0.1 * j;
      const Vec2 at = made.plane.pixel({x, y, 20});
      const auto pixel = static_cast<std::size_t>(std::floor(at.y) * 256 + std::floor(at.x));
      ASSERT_EQ(of_pixel[pixel], 1) << x << ' ' << y;
      ++inside;
    }
  EXPECT_GT(inside, 100000);
}

TEST_F(SlbPlanTest, VerticesAreRoundedNearestAndCastersUp) {
  const SlbPlan made = plan({0, 0, -1});
  golden::StreamWriter writer(made.config);
  const int s = made.config.subpixel_bits;
  outline::ObjectOutline outline;
  outline.object = 7;
  const double ulp = std::ldexp(1.0, -s);
  outline.loops = {{{2 + 0.4 * ulp, 2, 10.25}, {5 + 0.6 * ulp, 2, 11}, {5, 6 - 0.6 * ulp, -3}}};
  draw_casters(writer, made, std::span(&outline, 1), std::vector<std::vector<golden::slb::CoverSample>>(1));
  const std::vector<golden::Word> vertices = items(writer, SlbOp::Loop);
  ASSERT_EQ(vertices.size(), 3u);
  const auto vertex = [&](std::size_t i) {
    return golden::slb::decode_vertex(vertices[i], made.config.slb_config());
  };
  EXPECT_EQ(vertex(0), (golden::slb::Vertex{std::int64_t{2} << s, std::int64_t{2} << s, 11}));
  EXPECT_EQ(vertex(1), (golden::slb::Vertex{(std::int64_t{5} << s) + 1, std::int64_t{2} << s, 11}));
  EXPECT_EQ(vertex(2), (golden::slb::Vertex{std::int64_t{5} << s, (std::int64_t{6} << s) - 1, 0}));
}

}  // namespace
}  // namespace gnomon::plan
