// SPDX-License-Identifier: Apache-2.0
// Restored lines and pictures of the buffer against the answers that the unit gives.
#include "host/slb/buffer_picture.hpp"

#include <gtest/gtest.h>

#include <gnomon/golden/slb/model.hpp>

#include "host/slb/restored_lines.hpp"
#include "tests/golden/slb/displacement.hpp"
#include "tests/host/slb/shapes.hpp"

namespace gnomon::slb {
namespace {

namespace gold = golden::slb;
namespace shapes = golden::slb::testing;

std::vector<gold::Entry> entries_of(const gold::SlbModel& model) {
  std::vector<gold::Entry> entries;
  for (int row = 0; row < model.config().side(); ++row)
    for (int column = 0; column < model.config().side(); ++column)
      entries.push_back(model.entry(column, row));
  return entries;
}

TEST(RestoredLines, CoverWhatTheUnitAnswers) {
  std::uint64_t compared = 0, covered = 0;
  for (const bool published : {false, true}) {
    for (const char* name : {"random 24-gon", "gear, pitch 3 px", "overlapping"}) {
      gold::SlbConfig config = test::small_plane(5);
      if (published) config.rounding = gold::Rounding::Published;
      gold::SlbModel model(config);
      shapes::draw(model, shapes::shape(name).make(config, 1));
      shapes::Random random(7);
      for (int row = 0; row < config.side(); ++row) {
        for (int column = 0; column < config.side(); ++column) {
          const gold::Entry entry = model.entry(column, row);
          if (entry.count == 0) continue;
          const auto groups = restore(entry, config);
          for (int i = 0; i < 16; ++i) {
            const gold::PixelPoint point{random.integer(0, 1 << 12) * 2 + 1,
                                         random.integer(0, 1 << 12) * 2 + 1, 14};
            const Vec2 place(std::ldexp(static_cast<double>(point.x), -14),
                             std::ldexp(static_cast<double>(point.y), -14));
            gold::Entry lines_only = entry;
            lines_only.full_depth = config.no_depth();
            const bool expected = gold::answer(lines_only, point, config.no_depth(), 0, config).shadow;
            bool found = false;
            for (const RestoredGroup& group : groups) found = found || group.covers(place);
            ASSERT_EQ(found, expected) << name << " " << column << " " << row;
            covered += expected ? 1U : 0U;
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 10000U);
  EXPECT_GT(covered, compared / 4);
  EXPECT_LT(covered, 3 * compared / 4);
}

TEST(RestoredLines, BoundOnlyWhereTheyDecide) {
  // A convex corner: x >= 0.25 and y >= 0.5.
  RestoredGroup group;
  group.lines = {{true, true, 0.25, 0}, {false, true, 0.5, 0}};
  group.chains = {{gold::FragmentOp::And, 0, 1}};
  EXPECT_TRUE(group.covers({0.5, 0.75}));
  EXPECT_FALSE(group.covers({0.1, 0.75}));
  EXPECT_TRUE(group.bounds(0, {0.25, 0.75}));
  EXPECT_FALSE(group.bounds(0, {0.25, 0.25}));
  EXPECT_TRUE(group.bounds(1, {0.75, 0.5}));
  EXPECT_FALSE(group.bounds(1, {0.1, 0.5}));
  EXPECT_NEAR(group.lines[0].distance({0.75, 0.3}), 0.5, 1e-12);
}

class BufferPictureTest : public testing::Test {
 protected:
  BufferPictureTest() : config_(test::small_plane(4)), model_(config_) {
    const LoopScene scene{{0.5, {{{10, 10}, {20, 10}, {20, 20}, {10.5, 20}}}}};
    reference_.emplace(scene, config_.side());
    model_.begin_object(0, true, 5);
    std::vector<gold::Vertex> loop;
    loop.reserve(4);
    for (const Vec2& v : scene[0].loops[0])
      loop.push_back({static_cast<std::int64_t>(v.x * 4096), static_cast<std::int64_t>(v.y * 4096), 5});
    model_.loop(loop);
    model_.fill();
    model_.end_object();
    entries_ = entries_of(model_);
  }
  static Colour at(const render::Image& image, int x, int y) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x));
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
  }
  gold::SlbConfig config_;
  gold::SlbModel model_;
  std::optional<PolygonReference> reference_;
  std::vector<gold::Entry> entries_;
};

TEST_F(BufferPictureTest, ShowsPixelsLinesAndGrid) {
  const render::Image image = buffer_picture(entries_, config_, {8, 13, 6, 4}, {40, 3});
  EXPECT_EQ(image.width, 240);
  EXPECT_EQ(image.height, 160);
  EXPECT_EQ(at(image, 60, 20), kLitColour);              // pixel 9
  EXPECT_EQ(at(image, 2 * 40 + 35, 20), kInsideColour);  // pixel 10, right of its line
  EXPECT_EQ(at(image, 2 * 40 + 4, 20), kLitColour);      // and left of it
  EXPECT_EQ(at(image, 3 * 40 + 20, 20), kFullColour);    // pixel 11
  // x = 10 + (y - 10) / 20 at y = 13.5, on the line.
  EXPECT_EQ(at(image, 2 * 40 + static_cast<int>(40 * 0.175), 20), kLineColours[0]);
  const Colour border = at(image, 3 * 40, 20);
  EXPECT_LT(border[0], kFullColour[0] + 30);
  EXPECT_NE(border, kFullColour);
}

TEST_F(BufferPictureTest, DrawsTheExactOutlineOnTop) {
  const render::Image image = buffer_picture(entries_, config_, {8, 13, 6, 4}, {40, 3}, reference_->edges());
  // Thinner than an image pixel: mixed with the stored line beneath.
  EXPECT_GT(at(image, 2 * 40 + static_cast<int>(40 * 0.175), 20)[0], 100);
}

TEST_F(BufferPictureTest, FindsTheBusiestWindow) {
  // Both corners of a side of 10 pixels do not fit a window of 6: one corner with most of its sides.
  const Window window = busiest_window(entries_, config_, 6);
  EXPECT_EQ(window.columns, 6);
  EXPECT_EQ(window.rows, 6);
  const auto holds = [&](int column, int row) {
    return column >= window.column && row >= window.row && column < window.column + 6 && row < window.row + 6;
  };
  EXPECT_TRUE(holds(10, 10) || holds(20, 10) || holds(20, 20) || holds(10, 20));
  EXPECT_EQ(busiest_window(entries_, config_, 1000), whole_plane(config_));
}

TEST_F(BufferPictureTest, ShowsOverflow) {
  entries_[5].overflow = true;
  const render::Image image = buffer_picture(entries_, config_, whole_plane(config_), {4, 1});
  EXPECT_EQ(image.width, 256);
  EXPECT_EQ(at(image, 5 * 4 + 2, 2), kOverflowColour);
  EXPECT_EQ(at(image, 6 * 4 + 2, 2), kLitColour);
}

TEST_F(BufferPictureTest, NeedsAWholePlane) {
  entries_.pop_back();
  EXPECT_THROW(buffer_picture(entries_, config_, whole_plane(config_), {}), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::slb
