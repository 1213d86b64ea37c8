// SPDX-License-Identifier: Apache-2.0
// Directed streams of the silhouette-line buffer: one function a situation.
#include "tests/support/slb_directed.hpp"

#include <algorithm>
#include <optional>
#include <span>

#include "tests/support/random.hpp"
#include "tests/support/slb_stage.hpp"

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Word;
using golden::slb::CoverSample;
using golden::slb::QueryPoint;
using golden::slb::SlbOp;
using golden::slb::Vertex;
using golden::slb::testing::Loop;
using golden::slb::testing::Polygon;

constexpr std::uint8_t op(SlbOp value) {
  return static_cast<std::uint8_t>(value);
}

/// Every op in every state, sound but for the state, with reserved flags, and with a count where none
/// belongs.
std::vector<Word> sequence_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  const Loop triangle = stage.loop({{1, 1}, {5, 2}, {3, 6}});
  std::vector<Word> items;
  for (const Vertex& v : triangle) items.push_back(encode(v, stage.slb));
  const auto send = [&](SlbOp which, std::uint8_t flags, bool with_items) {
    const std::span<const Word> list = with_items ? std::span<const Word>(items) : std::span<const Word>();
    stage.raw({op(which), flags, static_cast<std::uint16_t>(list.size()), 0x03000010}, list);
  };
  for (int state = 0; state < 5; ++state) {
    for (std::uint8_t code = op(SlbOp::Clear); code <= op(SlbOp::ReadEntries); ++code) {
      for (const std::uint8_t flags : {std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{2}}) {
        for (const bool with_items : {false, true}) {
          if (state > 0) send(SlbOp::BeginObject, 1, false);
          if (state == 2 || state == 4) send(SlbOp::Loop, 0, true);
          if (state == 3) send(SlbOp::Loop, 1, true);
          if (state == 4) send(SlbOp::Fill, 0, false);
          send(static_cast<SlbOp>(code), flags, with_items);
          for (const SlbOp back : {SlbOp::Loop, SlbOp::Fill, SlbOp::EndObject}) send(back, 0, false);
          stage.raw({static_cast<std::uint8_t>(golden::Op::Fence), 1, 0, code});
        }
      }
    }
  }
  return stage.finish();
}

/// Commands of the projection unit and the processor between any two of an object.
std::vector<Word> between_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  Random random(1000);
  const auto other = [&] {
    std::vector<golden::VoxelItem> voxels(static_cast<std::size_t>(random.between(1, 9)));
    for (golden::VoxelItem& voxel : voxels) {
      for (auto& p : voxel.position) p = static_cast<std::uint32_t>(random.bits()) & 15;
      voxel.normal = {0, 0, -1};
    }
    stage.writer.project(voxels);
    if (config.en_vpu_offset) stage.writer.resolve(voxels, false);
    stage.writer.set_register(golden::Register::OffsetFactor, random.between(0, 65536));
    stage.writer.read_plane(0, 3);
    stage.writer.clear_plane();
    stage.writer.fence(static_cast<std::uint32_t>(random.bits()), random.chance(50));
  };
  const double side = stage.side;
  for (const bool flat : {true, false}) {
    stage.writer.begin_object(9, flat ? std::optional(100U) : std::nullopt);
    other();
    stage.writer.loop(stage.loop({{0.3, 0.2}, {side - 0.6, 0.9}, {side / 2, side - 0.4}}, 90));
    other();
    stage.writer.loop(stage.loop({{1.5, 1.2}, {2.5, 3.2}, {4.2, 1.4}}, 95));
    other();
    stage.writer.fill();
    other();
    stage.writer.cover(std::vector<CoverSample>{{2, 2, 120, 4}, {3, 2, 110, 31}}, 3);
    other();
    stage.writer.end_object();
    other();
    stage.ask_everywhere(100);
    other();
    stage.read();
  }
  return stage.finish();
}

/// One loop in pieces of every length, empty pieces among them; loops of none, one and two vertices.
std::vector<Word> pieces_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  golden::slb::testing::Random random(7);
  const Loop loop =
      stage.loop(star(random, 24, 0.2 * stage.side, 0.45 * stage.side, {stage.side / 2.0, stage.side / 2.0}));
  std::vector<Word> items;
  for (const Vertex& v : loop) items.push_back(encode(v, stage.slb));
  for (const std::size_t length : {1U, 2U, 3U, 7U, 24U}) {
    stage.raw({op(SlbOp::BeginObject), 1, 0, 50});
    std::span<const Word> rest = items;
    while (!rest.empty()) {
      const auto part = rest.first(std::min(length, rest.size()));
      stage.raw({op(SlbOp::Loop), 1, 0, 0});
      stage.raw({op(SlbOp::Loop), 1, static_cast<std::uint16_t>(part.size()), 0}, part);
      rest = rest.subspan(part.size());
    }
    stage.raw({op(SlbOp::Loop), 0, 0, 0});  // closes it
    for (std::uint16_t count = 0; count < 3; ++count) {
      stage.raw({op(SlbOp::Loop), 0, count, 0}, std::span(items).first(count));
    }
    stage.raw({op(SlbOp::Fill), 0, 0, 0});
    stage.raw({op(SlbOp::EndObject), 0, 0, 0});
    stage.ask_everywhere(50);
    stage.writer.slb_clear();
  }
  return stage.finish();
}

/// Many chains and many objects in the same pixels, near to far, far to near, and equally far.
std::vector<Word> overflow_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  const double side = stage.side;
  for (int order = 0; order < 3; ++order) {
    for (int i = 0; i < 7; ++i) {
      const std::uint32_t depth = order == 0   ? 20U + static_cast<unsigned>(i)
                                  : order == 1 ? 60U - static_cast<unsigned>(i)
                                               : 40U;
      std::vector<Polygon> strips;
      for (int strip = 0; strip <= i % 5; ++strip) {
        const double y = side / 2 + 0.21 * strip + 0.03 * i;
        strips.push_back({{0.4, y}, {side - 0.7, y + 0.3}, {side - 0.6, y + 0.4}, {0.3, y + 0.1}});
      }
      stage.object(static_cast<std::uint8_t>(i), depth, strips);
    }
    stage.ask(side / 2, side / 2 + 0.4, 1.5, 40);
    stage.read();
    stage.writer.fence(static_cast<std::uint32_t>(order), true);
    stage.writer.slb_clear();
  }
  return stage.finish();
}

/// Zero area, spikes, repeats, loops of one pixel, corners and borders hit exactly, edges there and back.
std::vector<Word> degenerate_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  const std::vector<std::vector<Polygon>> objects{
      {{{1, 1}, {6, 1}, {3, 1}}},
      {{{1, 1}, {4, 4}, {6, 6}, {2, 2}}},
      {{{1.5, 1.5}, {6.2, 1.7}, {6.2, 1.7}, {4, 1.7}, {6.3, 1.7}, {4, 5.5}, {4, 5.5}, {1.5, 1.5}}},
      {{{2.2, 2.2}, {2.8, 2.3}, {2.5, 2.9}}, {{2.25, 2.2}, {2.3, 2.8}, {2.7, 2.3}}},
      {SlbStage::rectangle(1, 2, 5, 6)},
      {SlbStage::rectangle(1, 2, 4, 5), SlbStage::rectangle(4, 2, 6, 5)},
      {SlbStage::rectangle(1, 1, 4, 4), SlbStage::rectangle(4, 4, 7, 7)},
      {SlbStage::rectangle(1.5, 1.5, 5.5, 5.5), {{1.5, 1.5}, {1.5, 5.5}, {5.5, 5.5}, {5.5, 1.5}}},
      {{{0, 0}, {7, 0}, {7, 7}, {0, 7}}, {{2, 2}, {2, 5}, {5, 5}, {5, 2}}},
      {{{1, 1}, {6, 6}, {6, 1}, {1, 6}}},
      {{{3, 0}, {6, 3}, {3, 6}, {0, 3}}},
      {{}, {{1, 1}}, {{1, 1}, {5, 5}}, {{1, 1}, {5, 5}, {1, 1}}},
  };
  for (const auto& polygons : objects) {
    stage.object(3, 30, polygons);
    stage.ask(4, 4, 4.2, 30);
    stage.read();
    stage.writer.slb_clear();
  }
  return stage.finish();
}

/// More turns around a pixel than the winding number holds, both ways, on the plane and left of it.
std::vector<Word> winding_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  for (const bool clockwise : {false, true}) {
    for (const double left : {2.5, -1.5}) {
      Polygon square = SlbStage::rectangle(left, 1.5, 4.5, 4.5);
      if (clockwise) std::reverse(square.begin(), square.end());
      stage.object(1, 10, std::vector<Polygon>(140, square));
      stage.ask(4, 4, 4.2, 10);
      stage.writer.fence(2, true);
      stage.writer.slb_clear();
    }
  }
  return stage.finish();
}

/// The ends of a coordinate's range, and loops beside, around and across the plane.
std::vector<Word> border_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  const double n = stage.side;
  const auto most = (std::int64_t{1} << (stage.slb.vertex_width() - 1)) - 1;
  stage.writer.begin_object(255, 5);
  stage.writer.loop(
      Loop{{-most - 1, -most - 1, 0}, {most, -most - 1, 0}, {most, most, 0}, {-most - 1, most, 0}});
  stage.writer.fill();
  stage.writer.end_object();
  stage.ask_everywhere(5);
  stage.writer.slb_clear();
  const Polygon diamond{{n / 2, -n / 3}, {n + n / 3, n / 2}, {n / 2, n + n / 3}, {-n / 3, n / 2}};
  for (const Polygon& polygon :
       {diamond, SlbStage::rectangle(-n, -n, 2 * n - 1, 2 * n - 1), SlbStage::rectangle(n, 0, n + 3, n),
        SlbStage::rectangle(-3, 0, 0, n), SlbStage::rectangle(0, n, n, n + 2),
        SlbStage::rectangle(0, -2, n, 0), SlbStage::rectangle(0, 0, n, n),
        SlbStage::rectangle(-2.5, n - 1.5, 1.5, n + 1.5)}) {
    stage.object(254, 6, {polygon});
    stage.ask_everywhere(6);
    stage.read();
    stage.writer.slb_clear();
  }
  return stage.finish();
}

/// More clears than generations, with something drawn and asked in between; fewer where the plane is large.
std::vector<Word> clears_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  const int clears = stage.slb.plane_log2 <= 8 ? 520 : 40;
  for (int i = 0; i < clears; ++i) {
    if (i % 9 == 0) stage.object(static_cast<std::uint8_t>(i), 7, {{{1.1, 1.2}, {5.3, 2.1}, {2.6, 5.2}}});
    if (i % 9 < 2 || i % 127 == 0) stage.ask(3, 3, 2.5, 7);
    stage.writer.slb_clear();
  }
  stage.ask(3, 3, 2.5, 7);
  stage.read();
  return stage.finish();
}

/// Samples in and around an object, one code before and behind the ends of the margin and of every range; a
/// second loop's rim lies where the first covers.
std::vector<Word> cover_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  for (const bool flat : {false, true}) {
    for (const std::uint32_t margin : {0U, 5U, stage.slb.no_depth()}) {
      stage.writer.begin_object(8, flat ? std::optional(40U) : std::nullopt);
      stage.writer.loop(stage.loop({{1.4, 1.3}, {6.6, 1.8}, {6.2, 6.4}, {1.7, 6.1}}, 40));
      stage.writer.loop(stage.loop({{2.4, 3.3}, {4.6, 2.8}, {4.2, 4.9}}, 40));
      stage.writer.fill();
      std::vector<CoverSample> samples;
      for (int row = -1; row < 9; ++row)
        for (int column = -1; column < 9; ++column)
          for (const std::uint32_t depth : {200U, 47U, 46U, 45U, 41U, 40U, 39U, 35U, 34U, 2U}) {
            samples.push_back(
                {column, row, depth, static_cast<std::uint32_t>(row + column + 2) * 7 % 32 / 4});
          }
      stage.writer.cover(samples, margin);
      stage.writer.end_object();
      stage.ask(4, 4, 4.5, 45);
      stage.read();
      stage.writer.slb_clear();
    }
  }
  return stage.finish();
}

/// The ends of depth and bias, and a query at the plane's every end.
std::vector<Word> query_stream(const HardwareConfig& config) {
  SlbStage stage(config);
  const std::uint32_t none = stage.slb.no_depth();
  for (const std::uint32_t depth : {0U, none - 1, none}) {
    stage.object(77, depth, {{{0.5, 0.5}, {6.5, 1.5}, {3.5, 6.5}}});
    for (const std::uint32_t bias : {0U, 1U, none}) stage.ask(4, 4, 4.5, depth, bias);
    stage.writer.slb_clear();
  }
  const auto most = (std::int64_t{1} << (stage.slb.query_width() - 1)) - 1;
  const std::int64_t end = std::int64_t{stage.side} << stage.slb.query_bits;
  std::vector<QueryPoint> points;
  for (const std::int64_t x : {-most - 1, std::int64_t{-1}, std::int64_t{0}, end - 1, end, most})
    for (const std::int64_t y : {-most - 1, std::int64_t{-1}, std::int64_t{0}, end - 1, end, most})
      points.push_back({x, y, none});
  stage.object(1, 3, {SlbStage::rectangle(-1, -1, stage.side + 1, stage.side + 1)});
  stage.writer.query(points, 0);
  return stage.finish();
}

}  // namespace

std::vector<DirectedStream> slb_directed_streams(const HardwareConfig& config) {
  return {{"slb_sequence", sequence_stream(config)},     {"slb_between", between_stream(config)},
          {"slb_pieces", pieces_stream(config)},         {"slb_overflow", overflow_stream(config)},
          {"slb_degenerate", degenerate_stream(config)}, {"slb_winding", winding_stream(config)},
          {"slb_borders", border_stream(config)},        {"slb_clears", clears_stream(config)},
          {"slb_cover", cover_stream(config)},           {"slb_queries", query_stream(config)}};
}

}  // namespace gnomon::stimulus
