// SPDX-License-Identifier: Apache-2.0
// Commands, their words and their errors; single voxels from item to answer.
#include <gtest/gtest.h>

#include <stdexcept>

#include "scenes.hpp"

namespace gnomon::test {
namespace {

using golden::topology::decode_list_head;
using golden::topology::decode_topology_result;
using golden::topology::describe_topology_result;
using golden::topology::ListHeadResult;
using golden::topology::TopologyError;
using golden::topology::TopologyOutcome;
using golden::topology::TopologyResult;
using golden::topology::TopologyUnit;

constexpr std::uint8_t kClear = 0x12, kPut = 0x13, kResolve = 0x14, kRead = 0x15;

std::vector<Word> words_of(const std::vector<Quad>& quads, const TopologyConfig& config) {
  std::vector<Word> words;
  for (const Quad& quad : quads)
    for (const Item& corner : quad) words.push_back(word_of(corner, config));
  return words;
}

TopologyUnit with_roof() {
  const TopologyConfig config = small_config();
  TopologyUnit unit(config);
  unit.set_registers(from_above(config));
  unit.execute(kPut, 0, 0, words_of({square(config, 4, 4, 2, 10)}, config));
  return unit;
}

TEST(TopologyUnit, AVoxelBelowAQuadIsInShadow) {
  TopologyUnit unit = with_roof();
  const TopologyConfig config = unit.lists().config();
  const auto below = unit.resolve(at(config, 5, 5, 2), false, 1000, false);
  EXPECT_TRUE(below.shadow && below.uncertain && below.hit);
  EXPECT_EQ(below.quad, 0U);
  EXPECT_EQ(below.tested, 1U);
  EXPECT_FALSE(unit.resolve(at(config, 7, 5, 2), false, 1000, false).shadow);
  EXPECT_FALSE(unit.resolve(at(config, 5, 5, 12), false, 1000, false).shadow);
  EXPECT_FALSE(unit.resolve(at(config, 5, 5, 10), false, 0, false).shadow) << "the quad's own place";
}

TEST(TopologyUnit, VoxelsFacingAwayAreInShadowWithoutALook) {
  TopologyUnit unit = with_roof();
  Item voxel = at(unit.lists().config(), 7, 5, 2);
  voxel.normal[2] = -voxel.normal[2];
  const auto away = unit.resolve(voxel, false, 0, false);
  EXPECT_TRUE(away.shadow && away.facing_away);
  EXPECT_EQ(away.visited, 0U);
  EXPECT_FALSE(unit.resolve(voxel, true, 0, false).shadow) << "the other side of an open surface";
  voxel.normal = {3, 0, 0};
  EXPECT_TRUE(unit.resolve(voxel, true, 0, false).facing_away) << "edge-on";
}

TEST(TopologyUnit, TheLiftMovesTheBeamAlongTheNormal) {
  const TopologyConfig config = small_config();
  auto registers = from_above(config);
  TopologyUnit unit(config);
  unit.execute(kPut, 0, 0, words_of({square(config, 4, 4, 2, 10)}, config));
  unit.set_registers(registers);
  unit.execute(kPut, 0, 0, words_of({square(config, 4, 4, 2, 10)}, config));
  Item voxel = at(config, 6.5, 5, 2);
  voxel.normal = {-181, 0, 180};
  EXPECT_FALSE(unit.resolve(voxel, false, 0, false).shadow);
  registers.offset_factor = (std::int64_t{4} << 16) / 255;  // a voxel is 4 ulps, the normal 255 long
  unit.set_registers(registers);
  EXPECT_TRUE(unit.resolve(voxel, false, 0, false).shadow);
}

TEST(TopologyUnit, ReservedFlagsCountsAndRangesAreErrors) {
  TopologyUnit unit = with_roof();
  const std::vector<Word> items(6, 0);
  const auto error = [&](std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) {
    return unit.execute(op, flags, arg, std::span(items).first(count)).error;
  };
  EXPECT_EQ(error(0x16, 0, 0, 0), TopologyError::UnknownOp);
  EXPECT_EQ(error(kClear, 1, 0, 0), TopologyError::ReservedFlag);
  EXPECT_EQ(error(kPut, 1, 0, 4), TopologyError::ReservedFlag);
  EXPECT_EQ(error(kResolve, 4, 0, 1), TopologyError::ReservedFlag);
  EXPECT_EQ(error(kRead, 2, 0, 1), TopologyError::ReservedFlag);
  EXPECT_EQ(error(kClear, 0, 0, 1), TopologyError::BadArgument);
  EXPECT_EQ(error(kPut, 0, 0, 6), TopologyError::BadArgument);
  EXPECT_EQ(error(kRead, 0, 0, 1), TopologyError::BadArgument);
  EXPECT_EQ(error(kRead, 0, 256, 0), TopologyError::BadArgument);
  EXPECT_EQ(error(kRead, 0, 1U << 24 | 255, 0), TopologyError::BadArgument);
  EXPECT_EQ(error(kRead, 0, 1U << 24 | 254, 0), TopologyError::None);
  EXPECT_EQ(unit.lists().counters().quads_put, 1U) << "commands in error put nothing";
  EXPECT_EQ(unit.lists().counters().resolved, 0U);
}

TEST(TopologyUnit, CommandsMayComeInPieces) {
  const TopologyConfig config = small_config();
  stimulus::Random random(9);
  std::vector<Quad> quads(50);
  for (Quad& quad : quads) quad = random_quad(random, config, 6);
  std::vector<Word> voxels(100);
  for (Word& voxel : voxels) voxel = word_of(random_item(random, config), config);
  const std::vector<Word> puts = words_of(quads, config);

  TopologyUnit whole(config), pieces(config);
  for (TopologyUnit* unit : {&whole, &pieces}) unit->set_registers(from_above(config));
  whole.execute(kPut, 0, 0, puts);
  const TopologyOutcome expected = whole.execute(kResolve, 1, 0, voxels);
  pieces.begin(kPut, 0, 0, puts.size());
  for (std::size_t i = 0; i < puts.size();) {
    const auto n = std::min<std::size_t>(puts.size() - i, static_cast<std::size_t>(random.between(1, 7)));
    EXPECT_TRUE(pieces.take(std::span(puts).subspan(i, n)).empty());
    i += n;
  }
  EXPECT_THROW(pieces.take(std::span(puts).first(1)), std::logic_error);
  pieces.begin(kResolve, 1, 0, voxels.size());
  std::vector<Word> results;
  for (const Word& word : voxels)
    for (const Word result : pieces.take(std::span(&word, 1))) results.push_back(result);
  EXPECT_EQ(results, expected.results);
  EXPECT_EQ(results.size(), 100U);
  EXPECT_EQ(pieces.lists().counters(), whole.lists().counters());
}

TEST(TopologyUnit, CountersAreThoseOfTheAnswers) {
  const TopologyConfig config = small_config();
  stimulus::Random random(10);
  TopologyUnit unit(config);
  unit.set_registers(from_above(config));
  for (int i = 0; i < 200; ++i) unit.put(random_quad(random, config, 6));
  golden::topology::TopologyCounters expected = unit.lists().counters();
  EXPECT_EQ(expected.quads_put, 200U);
  for (int i = 0; i < 500; ++i) {
    const TopologyResult r = unit.resolve(random_item(random, config), false, 500, false);
    ++expected.resolved;
    expected.facing_away += r.facing_away ? 1U : 0U;
    expected.off_plane += r.off_plane ? 1U : 0U;
    expected.uncertain += r.uncertain ? 1U : 0U;
    expected.hit += r.hit ? 1U : 0U;
    expected.shadow += r.shadow ? 1U : 0U;
    expected.nodes_visited += r.visited;
    expected.quads_tested += r.tested;
  }
  EXPECT_EQ(unit.lists().counters(), expected);
  EXPECT_GT(expected.hit, 20U);
}

TEST(TopologyUnit, ListHeadsAreRead) {
  TopologyUnit unit = with_roof();
  const TopologyOutcome read = unit.execute(kRead, 0, 15U << 24 | 4 * 16, {});
  ASSERT_EQ(read.results.size(), 16U);
  for (std::uint32_t i = 0; i < 16; ++i) {
    const ListHeadResult r = decode_list_head(read.results[i]);
    EXPECT_EQ(r.index, 64 + i);
    EXPECT_EQ(r.head.present, i >= 4 && i <= 6);
    EXPECT_EQ(r.head.near, r.head.present ? 5250U : 0U);
  }
  unit.execute(kClear, 0, 0, {});
  const TopologyOutcome cleared = unit.execute(kRead, 0, 4 * 16 + 5, {});
  EXPECT_EQ(cleared.results, (std::vector<Word>{Word{0x15} << 56 | Word{69} << 32}));
}

TEST(TopologyCodec, ResultBitsAreThoseOfThePage) {
  const TopologyResult result{
      .shadow = true, .uncertain = true, .hit = true, .quad = 0x123456, .visited = 0xABC, .tested = 0xDE};
  const Word word = encode(result);
  EXPECT_EQ(word, Word{0x148C123456ABC0DE});
  EXPECT_EQ(decode_topology_result(word), result);
  TopologyResult many = result;
  many.visited = many.tested = 100000;
  EXPECT_EQ(encode(many) & 0xFFFFFF, 0xFFFFFFU);
  EXPECT_EQ(encode(TopologyResult{}), Word{0x1440FFFFFF000000});
  EXPECT_EQ(encode(TopologyResult{.shadow = true, .facing_away = true}), Word{0x14A0FFFFFF000000});
  EXPECT_EQ(encode(TopologyResult{.off_plane = true}), Word{0x1450FFFFFF000000});
  EXPECT_EQ(encode(TopologyResult{.shadow = true, .uncertain = true, .fallback = true}),
            Word{0x148AFFFFFF000000});
  const TopologyResult outside{.shadow = true, .outside_cone = true}, behind{.shadow = true, .behind = true};
  EXPECT_EQ(encode(outside), Word{0x1481FFFFFF000000});
  EXPECT_EQ(encode(behind), Word{0x1483FFFFFF000000});
  for (const TopologyResult& unreached : {outside, behind})
    EXPECT_EQ(decode_topology_result(encode(unreached)), unreached);
  const ListHeadResult head{.index = 0xABCDEF,
                            .head = {.present = true, .linked = true, .dropped = true, .near = 0x123456}};
  EXPECT_EQ(encode(head), Word{0x15ABCDEFE0123456});
  EXPECT_EQ(decode_list_head(encode(head)), head);
  EXPECT_EQ(describe_topology_result(word),
            "TOPOLOGY_STATE state=2 facing_away=0 off_plane=0 uncertain=1 hit=1 fallback=0 quad=1193046 "
            "visited=2748 tested=222");
  EXPECT_EQ(describe_topology_result(encode(head)),
            "LIST_HEAD entry=11259375 present=1 linked=1 dropped=1 near=1193046");
}

TEST(TopologyCodec, ItemsAreThoseOfTheCommandStream) {
  const TopologyConfig config = small_config();
  stimulus::Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Item item = random_item(random, config);
    const Item decoded = golden::topology::decode_item(word_of(item, config), config);
    EXPECT_EQ(decoded.position, item.position);
    EXPECT_EQ(decoded.normal, item.normal);
  }
}

}  // namespace
}  // namespace gnomon::test
