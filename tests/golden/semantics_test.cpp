// SPDX-License-Identifier: Apache-2.0
// Commands, errors, sticky flags and counters of docs/command-stream.md, one rule a test.
#include <gtest/gtest.h>

#include <algorithm>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>
#include <map>
#include <string>

#include "tests/golden/run_stream.hpp"

namespace gnomon::golden_test {
namespace {

using golden::ErrorCode;
using golden::HardwareConfig;
using golden::Header;
using golden::Op;
using golden::PlaneRange;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;
using golden::Word;

constexpr std::uint8_t op(Op value) {
  return static_cast<std::uint8_t>(value);
}
constexpr std::uint8_t kUnknown = 0x05;
const HardwareConfig kFull;
const HardwareConfig kNoOffset{.en_vpu_offset = false};

Word fence_word(std::uint32_t sticky, std::uint32_t tag) {
  return golden::encode(golden::FenceResult{.sticky = sticky, .tag = tag});
}
Word error_word(ErrorCode error, std::uint32_t index) {
  return golden::encode(golden::ErrorResult{static_cast<std::uint8_t>(error), index});
}
std::vector<Word> fence(std::uint32_t tag, bool clear = false) {
  return command({op(Op::Fence), clear ? golden::kFenceClearSticky : std::uint8_t{0}, 0, tag});
}

/// u = x + offset, v = y, depth = z + depth_offset; light along +z.
StreamWriter identity_writer(const HardwareConfig& config, std::int64_t u_offset = 0,
                             std::int64_t d_offset = 0) {
  StreamWriter writer(config);
  const std::int64_t one = std::int64_t{1} << config.matrix_frac_bits;
  const std::int64_t code = std::int64_t{1} << (config.position_bits() + 4);
  writer.set_register(Register::MatrixUx, one);
  writer.set_register(Register::MatrixVy, one);
  writer.set_register(Register::MatrixDz, code);
  writer.set_register(Register::MatrixU1, u_offset * one);
  writer.set_register(Register::MatrixD1, d_offset * code);
  return writer;
}

struct ErrorCase {
  Header header;
  ErrorCode expected;
  HardwareConfig config = kFull;
};

/// Single errors, and headers to which several apply: the first of 1, 5, 2, 3, 4 is reported.
TEST(Semantics, ErrorsAndTheirOrder) {
  const std::uint32_t last = 512 * 512 - 1;
  const std::uint32_t beyond = golden::encode(PlaneRange{.first = last, .count = 2});
  const ErrorCase cases[] = {
      {{kUnknown, 0, 0, 0}, ErrorCode::UnknownOp},
      {{kUnknown, 0xFF, 3, 0xFFFFFFFF}, ErrorCode::UnknownOp},
      {{0x0F, 0, 1, 0}, ErrorCode::UnknownOp},
      {{0x16, 0, 1, 0}, ErrorCode::UnknownOp},
      {{0x12, 0, 1, 0}, ErrorCode::FeatureAbsent},
      {{0x14, 4, 1, 0}, ErrorCode::ReservedFlag},
      {{0x14, 0xC0, 1, 0}, ErrorCode::FeatureAbsent},
      {{0x30, 0, 1, 0}, ErrorCode::FeatureAbsent},
      {{0x30, 1, 0, 0}, ErrorCode::ReservedFlag},
      {{0x31, 1, 3, 0}, ErrorCode::FeatureAbsent},
      {{0x31, 2, 3, 0}, ErrorCode::ReservedFlag},
      {{0x32, 0, 1, 0}, ErrorCode::UnknownOp},
      {{op(Op::ResolveVoxels), 0x41, 2, 0}, ErrorCode::FeatureAbsent},
      {{op(Op::ResolveVoxels), 0x82, 2, 0}, ErrorCode::ReservedFlag},
      {{0x15, 0, 0, 0xFFFFFFFF}, ErrorCode::FeatureAbsent},
      {{0xFF, 0, 1, 0}, ErrorCode::UnknownOp},
      {{op(Op::Nop), 1, 2, 0}, ErrorCode::ReservedFlag},
      {{op(Op::SetRegisters), 1, 1, 0}, ErrorCode::ReservedFlag},
      {{op(Op::SetRegisters), 0x80, 1, 99}, ErrorCode::ReservedFlag},
      {{op(Op::ClearPlane), 2, 1, 0}, ErrorCode::ReservedFlag},
      {{op(Op::Fence), 2, 0, 0}, ErrorCode::ReservedFlag},
      {{op(Op::Fence), 3, 1, 0}, ErrorCode::ReservedFlag},
      {{op(Op::ReadPlane), 1, 0, beyond}, ErrorCode::ReservedFlag},
      {{op(Op::ProjectVoxels), 1, 2, 0}, ErrorCode::ReservedFlag},
      {{op(Op::ResolveVoxels), 2, 2, 0}, ErrorCode::ReservedFlag},
      {{op(Op::ResolveVoxels), 2, 2, 0}, ErrorCode::ReservedFlag, kNoOffset},
      {{op(Op::ResolveVoxels), 0, 2, 0}, ErrorCode::FeatureAbsent, kNoOffset},
      {{op(Op::ResolveVoxels), 1, 0, 0}, ErrorCode::FeatureAbsent, kNoOffset},
      {{op(Op::SetRegisters), 0, 1, 18}, ErrorCode::FeatureAbsent},
      {{op(Op::SetRegisters), 0, 19, 0}, ErrorCode::FeatureAbsent},
      {{op(Op::SetRegisters), 0, 0, 32}, ErrorCode::FeatureAbsent},
      {{op(Op::SetRegisters), 0, 1, 32}, ErrorCode::BadRegister},
      {{op(Op::SetRegisters), 0, 33, 0}, ErrorCode::BadRegister},
      {{op(Op::SetRegisters), 0, 1, 32}, ErrorCode::BadRegister, {.en_perspective = true}},
      {{op(Op::SetRegisters), 0, 0, 33}, ErrorCode::BadRegister, {.en_perspective = true}},
      {{op(Op::SetRegisters), 0, 2, 0xFFFFFFFF}, ErrorCode::BadRegister},
      {{op(Op::ClearPlane), 0, 1, 0}, ErrorCode::BadArgument},
      {{op(Op::Fence), 1, 1, 0}, ErrorCode::BadArgument},
      {{op(Op::ReadPlane), 0, 1, 0}, ErrorCode::BadArgument},
      {{op(Op::ReadPlane), 0, 0, beyond}, ErrorCode::BadArgument},
      {{op(Op::ReadPlane), 0, 0, 0x00FFFFFF}, ErrorCode::BadArgument},
  };
  for (const ErrorCase& c : cases) {
    const Word word = golden::encode(c.header);
    // Two NOPs before, so that the index is 2; the items must be skipped, or they would be taken for
    // commands.
    const auto stream =
        command({op(Op::Nop), 0, 1, 0}, {word}) + command({op(Op::Nop), 0, 0, 7}) +
        command(c.header, std::vector<Word>(c.header.count, golden::encode(Header{kUnknown, 0, 0, 0}))) +
        fence(42);
    const Outcome outcome = run(c.config, stream);
    const std::vector<Word> expected{error_word(c.expected, 2), fence_word(golden::kStickyErrorSeen, 42)};
    EXPECT_EQ(compare(expected, outcome.results).first, "") << golden::describe_header(word);
    EXPECT_EQ(outcome.events.at("ERRORS"), 1u);
    EXPECT_EQ(outcome.events.at("COMMANDS"), 4u);
  }
}

TEST(Semantics, TheLastLegalArgumentsAreLegal) {
  const std::uint32_t last = 512 * 512 - 1;
  const auto stream =
      command({op(Op::SetRegisters), 0, 1, 17}, {5}) + command({op(Op::SetRegisters), 0, 0, 18}) +
      command({op(Op::SetRegisters), 0, 18, 0}, std::vector<Word>(18, 0)) +
      command({op(Op::ReadPlane), 0, 0, golden::encode(PlaneRange{last, 1})}) +
      command({op(Op::ReadPlane), 0, 0, golden::encode(PlaneRange{last - 255, 256})}) +
      command({op(Op::ClearPlane), 0, 0, 0xFFFFFFFF}) + command({op(Op::ProjectVoxels), 0, 0, 0xFF}) +
      command({op(Op::ResolveVoxels), 1, 0, 0xFF});
  const Outcome outcome = run(kFull, stream);
  EXPECT_EQ(outcome.events.at("ERRORS"), 0u);
  EXPECT_EQ(outcome.results.size(), 257u);
}

TEST(Semantics, ACommandInErrorHasNoOtherEffect) {
  StreamWriter writer = identity_writer(kFull);
  const VoxelItem voxel{{3, 4, 5}, {0, 0, -255}};
  writer.project(std::vector<VoxelItem>{voxel});
  const Word item = golden::encode(voxel, kFull);
  const Word moved = golden::encode(VoxelItem{{9, 9, 9}, {}}, kFull);
  const auto stream =
      writer.take() + command({op(Op::SetRegisters), 0, 19, 0}, std::vector<Word>(19, 0)) +
      command({op(Op::SetRegisters), 0, 3, 16}, {1, 1, 1}) + command({op(Op::ClearPlane), 0, 1, 0}, {0}) +
      command({op(Op::ProjectVoxels), 4, 1, 0}, {moved}) + command({op(Op::Fence), 1, 1, 9}, {0}) +
      command({op(Op::ResolveVoxels), 4, 1, 0}, {item}) + command({op(Op::ResolveVoxels), 0, 1, 0}, {item}) +
      fence(1);
  const Outcome outcome = run(kFull, stream);
  ASSERT_EQ(outcome.results.size(), 8u);
  EXPECT_EQ(golden::describe_result(outcome.results[6]), "VOXEL_STATE lit nearest=5 delta=0");
  EXPECT_EQ(outcome.results[7], fence_word(golden::kStickyErrorSeen, 1));
  EXPECT_EQ(outcome.plane[9 * 512 + 9], golden::kEmpty);
  EXPECT_EQ(outcome.events.at("VOXELS_PROJECTED"), 1u);
  EXPECT_EQ(outcome.events.at("VOXELS_RESOLVED"), 1u);
}

TEST(Semantics, NopSkipsItsItems) {
  const Word poison = golden::encode(Header{kUnknown, 0, 0, 0});
  const Outcome outcome =
      run(kFull, command({op(Op::Nop), 0, 3, 0xABC}, {poison, poison, poison}) + fence(3));
  EXPECT_EQ(outcome.results, std::vector<Word>{fence_word(0, 3)});
  EXPECT_EQ(outcome.events.at("COMMANDS"), 2u);
}

TEST(Semantics, StickyFlagsStayUntilAFenceClearsThem) {
  // x = 0 is off the plane, x = 1 is on it; z = 0 is below the depth range.
  StreamWriter writer = identity_writer(kFull, -1, -1);
  writer.fence(0, false);
  writer.project(std::vector<VoxelItem>{{{0, 0, 5}, {}}});
  writer.fence(1, false);
  writer.project(std::vector<VoxelItem>{{{1, 0, 0}, {}}});
  writer.fence(2, false);
  writer.fence(3, true);
  writer.fence(4, false);
  writer.project(std::vector<VoxelItem>{{{0, 0, 0}, {}}});  // both, but dropped: off the plane only
  writer.fence(5, true);
  writer.project(std::vector<VoxelItem>{{{1, 0, 1}, {}}});
  writer.resolve(std::vector<VoxelItem>{{{0, 0, 0}, {}}, {{1, 0, 0}, {}}},
                 false);  // neither is flagged in a resolve
  writer.fence(6, true);
  const Outcome outcome = run(kFull, writer.words());
  const std::uint32_t off = golden::kStickyOffPlane, saturated = golden::kStickyDepthSaturated;
  ASSERT_EQ(outcome.results.size(), 9u);
  EXPECT_EQ(outcome.results[0], fence_word(0, 0));
  EXPECT_EQ(outcome.results[1], fence_word(off, 1));
  EXPECT_EQ(outcome.results[2], fence_word(off | saturated, 2));
  EXPECT_EQ(outcome.results[3], fence_word(off | saturated, 3));
  EXPECT_EQ(outcome.results[4], fence_word(0, 4));
  EXPECT_EQ(outcome.results[5], fence_word(off, 5));
  EXPECT_EQ(outcome.results[8], fence_word(0, 6));
  EXPECT_EQ(outcome.events.at("PROJECT_OFF_PLANE"), 2u);
  EXPECT_EQ(outcome.events.at("PROJECT_SATURATED"), 1u);
  EXPECT_EQ(outcome.events.at("VOXELS_PROJECTED"), 4u);
}

TEST(Semantics, ReadPlaneGivesEntriesInOrder) {
  StreamWriter writer = identity_writer(kFull);
  writer.project(std::vector<VoxelItem>{{{2, 1, 9}, {}}, {{4, 1, 3}, {}}});
  writer.read_plane(512 + 1, 4);
  writer.clear_plane();
  writer.read_plane(512 + 2, 1);
  const Outcome outcome = run(kFull, writer.words());
  std::vector<std::string> texts;
  for (const Word word : outcome.results) texts.push_back(golden::describe_result(word));
  EXPECT_EQ(texts, (std::vector<std::string>{"PLANE_ENTRY index=513 empty", "PLANE_ENTRY index=514 depth=9",
                                             "PLANE_ENTRY index=515 empty", "PLANE_ENTRY index=516 depth=3",
                                             "PLANE_ENTRY index=514 empty"}));
}

/// One voxel for each way through the resolve pass; the light comes along +z, the offset moves by one entry.
TEST(Semantics, EveryOutcomeOfResolveAndItsCounter) {
  const HardwareConfig config;
  StreamWriter writer = identity_writer(config);
  writer.set_register(Register::OffsetFactor, 65536 / 255 + 1);  // one ulp along a unit normal
  writer.set_register(Register::DeltaMax, 100);
  writer.set_register(Register::MarginSquared, 1000);
  writer.set_register(Register::FacingShift, 12);  // g_d is in 2^14 codes, g_u in 2^22 entries
  writer.set_register(Register::TiltShift, 20);
  const std::int32_t one = 255;
  writer.project(std::vector<VoxelItem>{{{10, 10, 20}, {}}, {{11, 10, 20}, {}}, {{13, 10, 600}, {}}});
  const VoxelItem voxels[] = {
      {{10, 10, 20}, {0, 0, one}},    // looks away from the light
      {{600, 10, 20}, {0, 0, one}},   // that, and off the plane
      {{600, 10, 20}, {0, 0, -one}},  // off the plane
      {{50, 50, 20}, {0, 0, -one}},   // an empty entry
      {{10, 10, 20}, {0, 0, -one}},   // it is the nearest
      {{10, 10, 60}, {0, -one, -1}},  // uncertain, and the offset lands on nothing
      {{10, 10, 200}, {0, 0, -one}},  // uncertain, far behind
      {{10, 10, 60}, {0, 0, -one}},   // uncertain, facing straight: no slope excuses the delta
      {{10, 10, 22}, {one, 0, -8}},   // uncertain, so steep that the slope excuses it
      {{13, 10, 601}, {0, 0, -one}},  // uncertain, but the offset point is not behind anything
      {{10, 10, 20}, {0, 0, 0}},      // no normal at all
  };
  writer.resolve(voxels, false);
  const Outcome outcome = run(config, writer.words());
  std::vector<std::string> texts;
  for (const Word word : outcome.results) texts.push_back(golden::describe_result(word).substr(12));
  EXPECT_EQ(texts, (std::vector<std::string>{
                       "shadow facing_away nearest=none delta=0",
                       "shadow facing_away off_plane nearest=none delta=0",
                       "lit off_plane nearest=none delta=0",
                       "lit nearest=none delta=0",
                       "lit nearest=20 delta=0",
                       "lit uncertain offset_empty nearest=20 delta=0",
                       "shadow uncertain beyond_max nearest=20 delta=178",
                       "shadow uncertain nearest=20 delta=38",
                       "lit uncertain nearest=20 delta=1",
                       "lit uncertain nearest=600 delta=0",
                       "shadow facing_away nearest=none delta=0",
                   }));
  const std::map<std::string, std::uint64_t> expected{{"COMMANDS", 12},          {"ERRORS", 0},
                                                      {"VOXELS_PROJECTED", 3},   {"PROJECT_OFF_PLANE", 0},
                                                      {"PROJECT_SATURATED", 0},  {"PLANE_WRITES", 3},
                                                      {"VOXELS_RESOLVED", 11},   {"RESOLVED_FACING_AWAY", 3},
                                                      {"RESOLVED_UNCERTAIN", 5}, {"RESOLVED_OFFSET_EMPTY", 1},
                                                      {"RESOLVED_SHADOW", 5}};
  EXPECT_EQ(outcome.events, expected);
}

/// DELTA_MAX itself is not beyond DELTA_MAX.
TEST(Semantics, DeltaAtAndBeyondItsLimit) {
  StreamWriter writer = identity_writer(kFull);
  writer.set_register(Register::DeltaMax, 7);
  writer.set_register(Register::DeltaShift, 63);  // nothing is left of delta for the slope test
  writer.project(std::vector<VoxelItem>{{{5, 5, 20}, {}}});
  writer.resolve(std::vector<VoxelItem>{{{5, 5, 27}, {0, 0, -255}}, {{5, 5, 28}, {0, 0, -255}}}, false);
  const Outcome outcome = run(kFull, writer.words());
  EXPECT_EQ(golden::describe_result(outcome.results[0]), "VOXEL_STATE lit uncertain nearest=20 delta=7");
  EXPECT_EQ(golden::describe_result(outcome.results[1]),
            "VOXEL_STATE shadow uncertain beyond_max nearest=20 delta=8");
}

TEST(Semantics, TwoSidedTurnsNormalsTowardsTheLight) {
  StreamWriter writer = identity_writer(kFull);
  const std::vector<VoxelItem> voxels{
      {{10, 10, 20}, {0, 0, 255}}, {{10, 10, 20}, {0, 0, 0}}, {{10, 10, 20}, {9, 9, 0}}};
  writer.project(voxels);
  writer.resolve(voxels, true);
  const Outcome outcome = run(kFull, writer.words());
  EXPECT_EQ(golden::describe_result(outcome.results[0]), "VOXEL_STATE lit nearest=20 delta=0");
  for (const std::size_t across : {1u, 2u}) {
    EXPECT_EQ(golden::describe_result(outcome.results[across]),
              "VOXEL_STATE shadow facing_away nearest=none delta=0");
  }
}

TEST(Semantics, ResetIsAsAfterPowerUpAlsoInTheMiddleOfACommand) {
  const auto engine = golden::make_golden_engine(kFull);
  StreamWriter writer = identity_writer(kFull, 0, -1);
  writer.project(std::vector<VoxelItem>{{{1, 1, 0}, {}}, {{700, 1, 1}, {}}});
  auto words =
      writer.take() + command({kUnknown, 0, 0, 0}) + command({op(Op::SetRegisters), 0, 18, 0}, {1, 2, 3});
  engine->submit(words);
  engine->reset();
  EXPECT_EQ(drain(*engine), std::vector<Word>{}) << "pending results are dropped";
  for (const auto& [name, count] : engine->counters().events) EXPECT_EQ(count, 0u) << name;
  // Registers are 0: any voxel lands in entry 0 at depth 0. A missing item of the cut command would swallow
  // the header.
  const Word item = golden::encode(VoxelItem{{100, 100, 100}, {}}, kFull);
  engine->submit(command({op(Op::ProjectVoxels), 0, 1, 0}, {item}) + command({kUnknown, 0, 0, 0}) + fence(8));
  EXPECT_EQ(drain(*engine), (std::vector<Word>{error_word(ErrorCode::UnknownOp, 1), fence_word(1, 8)}));
  const auto plane = engine->read_plane();
  EXPECT_EQ(plane[0], 0u);
  EXPECT_EQ(std::count(plane.begin(), plane.end(), golden::kEmpty), 512 * 512 - 1);
}

TEST(Semantics, StatePersistsAcrossSubmitsAndDrains) {
  const auto engine = golden::make_golden_engine(kFull);
  StreamWriter writer = identity_writer(kFull);
  writer.project(std::vector<VoxelItem>{{{3, 3, 3}, {}}});
  engine->submit(writer.take());
  EXPECT_EQ(drain(*engine), std::vector<Word>{});
  writer.read_plane(3 * 512 + 3, 1);
  engine->submit(writer.take());
  EXPECT_EQ(drain(*engine).size(), 1u);
  EXPECT_EQ(drain(*engine), std::vector<Word>{}) << "a result is given once";
  EXPECT_EQ(engine->name(), "golden");
  EXPECT_EQ(engine->config(), kFull);
  EXPECT_TRUE(engine->counters().cycles.empty());
}

}  // namespace
}  // namespace gnomon::golden_test
