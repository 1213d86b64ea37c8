// SPDX-License-Identifier: Apache-2.0
// The mode inside the golden engine: registers, errors, flags and counters of the one stream.
#include <gtest/gtest.h>

#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>

#include "scenes.hpp"

namespace gnomon::test {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;

HardwareConfig hardware() {
  const TopologyConfig small = small_config();
  HardwareConfig config;
  config.voxel_bits = small.voxel_bits;
  config.plane_log2 = small.plane_log2;
  config.en_vpu_topology = true;
  config.nodes_log2 = small.nodes_log2;
  config.quads_log2 = small.quads_log2;
  return config;
}

VoxelItem voxel(const Item& item) {
  return {item.position, item.normal};
}
std::array<VoxelItem, 4> corners(const Quad& quad) {
  return {voxel(quad[0]), voxel(quad[1]), voxel(quad[2]), voxel(quad[3])};
}

void set_registers(StreamWriter& writer, const ProjectionRegisters& registers) {
  writer.set_registers(Register::MatrixUx, registers.matrix);
  writer.set_register(Register::OffsetFactor, registers.offset_factor);
}

std::vector<Word> run(golden::Engine& engine, std::span<const Word> words) {
  std::vector<Word> results;
  engine.submit(words);
  engine.drain([&](std::span<const Word> some) { results.insert(results.end(), some.begin(), some.end()); });
  return results;
}

TEST(TopologyEngine, AnswersAreTheUnits) {
  const HardwareConfig config = hardware();
  const TopologyConfig topology = config.topology_config();
  stimulus::Random random(5);
  const ProjectionRegisters registers = from_above(topology);
  golden::topology::TopologyUnit unit(topology);
  unit.set_registers(registers);
  StreamWriter writer(config);
  set_registers(writer, registers);
  writer.clear_lists();
  std::vector<std::array<VoxelItem, 4>> quads;
  for (int i = 0; i < 200; ++i) {
    const Quad quad = random_quad(random, topology, 3);
    unit.put(quad);
    quads.push_back(corners(quad));
  }
  writer.put_quads(quads);
  std::vector<VoxelItem> items;
  std::vector<Word> expected;
  for (int i = 0; i < 500; ++i) {
    const Item item = random_item(random, topology);
    items.push_back(voxel(item));
    expected.push_back(golden::topology::encode(unit.resolve(item, true, 700, false)));
  }
  writer.resolve_topology(items, true, 700, false);
  writer.read_lists(0, 256);
  for (std::uint32_t i = 0; i < 256; ++i)
    expected.push_back(golden::topology::encode(golden::topology::ListHeadResult{i, unit.lists().head(i)}));

  const auto engine = golden::make_golden_engine(config);
  const std::vector<Word> words = writer.take();
  EXPECT_EQ(run(*engine, words), expected);
  EXPECT_EQ(engine->counters().events.at("QUADS_PUT"), 200u);
  EXPECT_EQ(engine->counters().events.at("TOPOLOGY_RESOLVED"), 500u);
  EXPECT_GT(engine->counters().events.at("TOPOLOGY_SHADOW"), 50u);

  // In pieces of any size it comes to the same.
  engine->reset();
  std::vector<Word> pieces;
  for (std::size_t at = 0; at < words.size(); at += 7) {
    const auto some = run(*engine, std::span(words).subspan(at, std::min<std::size_t>(7, words.size() - at)));
    pieces.insert(pieces.end(), some.begin(), some.end());
  }
  EXPECT_EQ(pieces, expected);
  const auto origin = golden::find_result(words, 499, config);
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->result, 499u);
  EXPECT_EQ(golden::describe_header(golden::encode(origin->command.header)).substr(0, 16),
            "RESOLVE_TOPOLOGY");
}

TEST(TopologyEngine, FlagsGoIntoTheFence) {
  HardwareConfig config = hardware();
  config.nodes_log2 = 4;
  StreamWriter writer(config);
  set_registers(writer, from_above(config.topology_config()));
  writer.put_quads(std::vector{corners(square(config.topology_config(), 1, 1, 8, 5))});
  writer.fence(1, true);
  writer.fence(2, false);
  const auto engine = golden::make_golden_engine(config);
  const std::vector<Word> words = writer.take();
  const std::vector<Word> results = run(*engine, words);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(golden::decode_fence_result(results[0]).sticky, golden::topology::kStickyListOverflow);
  EXPECT_EQ(golden::decode_fence_result(results[1]).sticky, 0u);
  EXPECT_GT(engine->counters().events.at("NODES_DROPPED"), 0u);
}

TEST(TopologyEngine, WithoutTheModeItsCommandsAreRefused) {
  HardwareConfig config = hardware();
  config.en_vpu_topology = false;
  StreamWriter writer(config);
  EXPECT_THROW(writer.clear_lists(), std::logic_error);
  const auto engine = golden::make_golden_engine(config);
  const std::vector<Word> header{golden::encode(golden::Header{.op = 0x12})};
  const std::vector<Word> results = run(*engine, header);
  ASSERT_EQ(results.size(), 1u);
  EXPECT_EQ(golden::decode_error_result(results[0]).error, 2);
  EXPECT_FALSE(engine->counters().events.contains("QUADS_PUT"));
}

TEST(TopologyEngine, ParametersOfAnAbsentModeDoNotMatter) {
  HardwareConfig a;
  HardwareConfig b;
  b.quads_log2 = 99;
  EXPECT_EQ(a, b);
  EXPECT_FALSE(b.check());
  a.en_vpu_topology = b.en_vpu_topology = true;
  EXPECT_NE(a, b);
  EXPECT_NE(b.check().value_or("").find("QUADS_LOG2"), std::string::npos);
}

}  // namespace
}  // namespace gnomon::test
