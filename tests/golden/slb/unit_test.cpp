// SPDX-License-Identifier: Apache-2.0
// Commands as words: codec, order, errors, and the same answers as the model called directly.
#include <gtest/gtest.h>

#include <gnomon/golden/slb/unit.hpp>

#include "tests/golden/slb/displacement.hpp"

namespace gnomon::golden::slb::testing {
namespace {

constexpr auto op(SlbOp code) {
  return static_cast<std::uint8_t>(code);
}

SlbConfig small() {
  SlbConfig config = slb4();
  config.plane_log2 = 4;
  return config;
}

std::vector<Word> words(const Loop& loop, const SlbConfig& config) {
  std::vector<Word> items;
  for (const Vertex& v : loop) items.push_back(encode(v, config));
  return items;
}

Loop triangle(const SlbConfig& config) {
  return quantise({{2.2, 2.6}, {13.4, 3.3}, {6.1, 12.9}}, config);
}

TEST(Unit, ItemsKeepEveryField) {
  for (const SlbConfig& config : {slb4(), slb7(), small()}) {
    ASSERT_EQ(check_items(config), std::nullopt);
    Random random(1);
    const std::int64_t limit = std::int64_t{1} << (config.vertex_width() - 1);
    const std::int64_t query_limit = std::int64_t{1} << (config.query_width() - 1);
    const std::int64_t cells = std::int64_t{2} * config.side();
    for (int i = 0; i < 500; ++i) {
      const auto depth = static_cast<std::uint32_t>(random.integer(0, config.no_depth()));
      const Vertex vertex{i == 0 ? -limit : random.integer(-limit, limit - 1),
                          i == 0 ? limit - 1 : random.integer(-limit, limit - 1), depth};
      EXPECT_EQ(decode_vertex(encode(vertex, config), config), vertex);
      const QueryPoint point{random.integer(-query_limit, query_limit - 1),
                             random.integer(-query_limit, query_limit - 1), depth};
      const QueryPoint back = decode_query(encode(point, config), config);
      EXPECT_TRUE(back.x == point.x && back.y == point.y && back.depth == point.depth);
      const CoverSample sample{random.integer(-cells, cells - 1), random.integer(-cells, cells - 1), depth,
                               static_cast<std::uint32_t>(i % 32)};
      const CoverSample cover = decode_cover(encode(sample, config), config);
      EXPECT_TRUE(cover.column == sample.column && cover.row == sample.row && cover.depth == depth &&
                  cover.range == sample.range);
    }
    EXPECT_THROW(encode(Vertex{limit, 0, 0}, config), std::out_of_range);
    EXPECT_THROW(encode(QueryPoint{0, -query_limit - 1, 0}, config), std::out_of_range);
    EXPECT_THROW(encode(Vertex{0, 0, config.no_depth() + 1}, config), std::out_of_range);
  }
}

TEST(Unit, AnswersKeepEveryField) {
  for (unsigned bits = 0; bits < 64; ++bits) {
    QueryAnswer answer;
    answer.shadow = (bits & 1) != 0;
    answer.by_full = (bits & 2) != 0;
    answer.by_lines = (bits & 4) != 0;
    answer.has_fragment = (bits & 8) != 0;
    answer.overflow = (bits & 16) != 0;
    answer.off_plane = (bits & 32) != 0;
    answer.object = static_cast<std::uint8_t>(bits * 4);
    const Word word = encode(answer, 0xBEEF);
    EXPECT_EQ(decode_answer(word), answer);
    EXPECT_EQ(answer_index(word), 0xBEEF);
    EXPECT_EQ(word >> 56, 0x26u);
    EXPECT_EQ((word >> 55 & 1) != 0, answer.shadow);
    EXPECT_NE(describe_answer(word).find("item=48879"), std::string::npos);
  }
}

TEST(Unit, AStreamGivesTheModelsAnswers) {
  const SlbConfig config = small();
  SlbUnit unit(config);
  SlbModel model(config);
  EXPECT_EQ(unit.execute(op(SlbOp::BeginObject), kBeginFlat, 7u << 24 | 33, {}).error, SlbError::None);
  const std::vector<Word> loop = words(triangle(config), config);
  // The loop in two commands.
  EXPECT_EQ(unit.execute(op(SlbOp::Loop), kLoopMore, 0, std::span(loop).first(2)).error, SlbError::None);
  EXPECT_EQ(unit.execute(op(SlbOp::Loop), 0, 0, std::span(loop).last(1)).error, SlbError::None);
  EXPECT_EQ(unit.execute(op(SlbOp::Fill), 0, 0, {}).error, SlbError::None);
  EXPECT_EQ(unit.execute(op(SlbOp::EndObject), 0, 0, {}).error, SlbError::None);
  model.begin_object(7, true, 33);
  model.loop(triangle(config));
  model.fill();
  model.end_object();
  Random random(3);
  std::vector<Word> items;
  std::vector<QueryAnswer> expected;
  const std::int64_t span = std::int64_t{16} << config.query_bits;
  for (int i = 0; i < 2000; ++i) {
    const QueryPoint point{random.integer(-span / 8, span), random.integer(-span / 8, span),
                           static_cast<std::uint32_t>(random.integer(30, 40))};
    items.push_back(encode(point, config));
    expected.push_back(model.query(point, 2));
  }
  const SlbOutcome outcome = unit.execute(op(SlbOp::Query), 0, 2, items);
  ASSERT_EQ(outcome.results.size(), expected.size());
  int shadows = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(decode_answer(outcome.results[i]), expected[i]);
    EXPECT_EQ(answer_index(outcome.results[i]), i);
    shadows += expected[i].shadow ? 1 : 0;
    if (expected[i].by_lines) {
      EXPECT_EQ(expected[i].object, 7);
    }
  }
  EXPECT_GT(shadows, 100);
  EXPECT_EQ(unit.model().counters(), model.counters());
}

TEST(Unit, EntriesComeBackWhole) {
  const SlbConfig config = small();
  SlbUnit unit(config);
  draw(unit.model(), {{triangle(config)}, {quantise({{3, 3}, {9, 3}, {9, 9}}, config)}});
  const SlbOutcome outcome = unit.execute(op(SlbOp::ReadEntries), 0, 255u << 24, {});
  const std::size_t raw = static_cast<std::size_t>(config.stored_entry_bits()) / 64;
  ASSERT_EQ(outcome.results.size(), 256 * (1 + raw));
  int fragments = 0;
  for (std::uint32_t i = 0; i < 256; ++i) {
    const auto begin = outcome.results.begin() + static_cast<std::ptrdiff_t>(i * (1 + raw));
    EXPECT_EQ(decode_entry_header(*begin), (EntryHeader{i, static_cast<std::uint8_t>(raw)}));
    const Entry entry =
        unpack_entry(std::vector<Word>(begin + 1, begin + 1 + static_cast<std::ptrdiff_t>(raw)), config);
    EXPECT_EQ(entry, unit.model().entry(static_cast<int>(i % 16), static_cast<int>(i / 16)));
    EXPECT_EQ(entry.corner, 0);
    fragments += entry.count;
    if (entry.count > 0) {
      EXPECT_NE(describe(entry).find("frac="), std::string::npos);
    }
  }
  EXPECT_GT(fragments, 20);
}

TEST(Unit, ErrorsInTheirOrderAndWithoutEffect) {
  const SlbConfig config = small();
  SlbUnit unit(config);
  const std::vector<Word> item(1, 0);
  const auto error = [&](SlbOp code, std::uint8_t flags, std::uint32_t arg, std::span<const Word> items) {
    return unit.execute(op(code), flags, arg, items).error;
  };
  EXPECT_EQ(unit.execute(0x28, 0, 0, {}).error, SlbError::UnknownOp);
  EXPECT_EQ(error(SlbOp::Clear, 1, 0, item), SlbError::ReservedFlag);
  EXPECT_EQ(error(SlbOp::BeginObject, 2, 0, {}), SlbError::ReservedFlag);
  EXPECT_EQ(error(SlbOp::Loop, 3, 0, {}), SlbError::ReservedFlag);
  EXPECT_EQ(error(SlbOp::Fill, 0, 0, item), SlbError::BadArgument);
  EXPECT_EQ(error(SlbOp::ReadEntries, 0, 256, {}), SlbError::BadArgument);
  EXPECT_EQ(error(SlbOp::ReadEntries, 0, 1u << 24 | 255, {}), SlbError::BadArgument);
  for (const SlbOp code : {SlbOp::Loop, SlbOp::Fill, SlbOp::Cover, SlbOp::EndObject})
    EXPECT_EQ(error(code, 0, 0, {}), SlbError::BadSequence);
  EXPECT_EQ(unit.model().counters(), SlbCounters{});

  EXPECT_EQ(error(SlbOp::BeginObject, 0, 0, {}), SlbError::None);
  for (const SlbOp code : {SlbOp::Clear, SlbOp::BeginObject, SlbOp::Query, SlbOp::ReadEntries, SlbOp::Cover})
    EXPECT_EQ(error(code, 0, 0, {}), SlbError::BadSequence);
  EXPECT_EQ(error(SlbOp::EndObject, 0, 0, {}), SlbError::None) << "an object without loops needs no FILL";
  EXPECT_EQ(error(SlbOp::BeginObject, 0, 0, {}), SlbError::None);
  EXPECT_EQ(error(SlbOp::Loop, kLoopMore, 0, {}), SlbError::None);
  for (const SlbOp code : {SlbOp::Fill, SlbOp::EndObject, SlbOp::Cover})
    EXPECT_EQ(error(code, 0, 0, {}), SlbError::BadSequence);
  EXPECT_EQ(error(SlbOp::Loop, 0, 0, {}), SlbError::None);
  EXPECT_EQ(error(SlbOp::EndObject, 0, 0, {}), SlbError::BadSequence) << "loops without FILL";
  EXPECT_EQ(error(SlbOp::Fill, 0, 0, {}), SlbError::None);
  EXPECT_EQ(error(SlbOp::Fill, 0, 0, {}), SlbError::BadSequence);
  EXPECT_EQ(error(SlbOp::Loop, 0, 0, {}), SlbError::BadSequence);
  EXPECT_EQ(error(SlbOp::Cover, 0, 0, item), SlbError::None);
  EXPECT_EQ(error(SlbOp::EndObject, 0, 0, {}), SlbError::None);
  EXPECT_EQ(error(SlbOp::Query, 0, 0, item), SlbError::None);
  EXPECT_EQ(unit.model().counters().queries, 1u);
}

TEST(Unit, WideItemsAreRefused) {
  SlbConfig config = slb7();
  config.plane_log2 = 12;
  EXPECT_TRUE(check_items(config)->find("SUBPIXEL_BITS") != std::string::npos);
  EXPECT_THROW(SlbUnit{config}, std::invalid_argument);
}

TEST(Unit, StickyFlagsHaveTheirBits) {
  EXPECT_EQ(encode(SlbSticky{true, false, false}), 0x100u);
  EXPECT_EQ(encode(SlbSticky{false, true, false}), 0x200u);
  EXPECT_EQ(encode(SlbSticky{false, false, true}), 0x400u);
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
