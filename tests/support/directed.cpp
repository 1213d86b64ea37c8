// SPDX-License-Identifier: Apache-2.0
// Directed streams: one function a situation.
#include <algorithm>
#include <array>
#include <cstddef>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>
#include <span>
#include <utility>

#include "tests/support/perspective_directed.hpp"
#include "tests/support/scene_registers.hpp"
#include "tests/support/slb_directed.hpp"
#include "tests/support/stimulus.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Header;
using golden::Op;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;
using golden::Word;

constexpr std::uint8_t op(Op value) {
  return static_cast<std::uint8_t>(value);
}

/// A writer that leaves out what the hardware cannot do, with the registers it has set.
struct Stage {
  Stage(const HardwareConfig& hardware, std::uint64_t seed)
      : config(hardware), random(seed), writer(hardware) {
    set(scene_registers(config, random));
  }

  void set(const RegisterValues& values) {
    registers = values;
    writer.set_registers(Register::MatrixUx, registers);
  }
  std::vector<VoxelItem> items(Pattern pattern, std::size_t count) {
    return voxel_pattern(pattern, count, registers, config, random);
  }
  void project_and_resolve(std::span<const VoxelItem> voxels) {
    writer.project(voxels);
    if (!config.en_vpu_offset) return;
    writer.resolve(voxels, false);
    writer.resolve(voxels, true);
  }
  std::vector<Word> finish() {
    writer.fence(0xF1A15, true);
    return writer.take();
  }

  HardwareConfig config;
  Random random;
  StreamWriter writer;
  RegisterValues registers{};
};

std::vector<Word> pattern_stream(const HardwareConfig& config, Pattern pattern) {
  Stage stage(config, 100 + static_cast<std::uint64_t>(pattern));
  for (int round = 0; round < 4; ++round) {
    stage.project_and_resolve(stage.items(pattern, 300));
    stage.set(scene_registers(config, stage.random));
  }
  return stage.finish();
}

/// Registers at their ends, all of them or some; positions at all ends.
std::vector<Word> extreme_stream(const HardwareConfig& config) {
  Stage stage(config, 200);
  for (const bool high : {false, true}) {
    RegisterValues values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto reg = static_cast<Register>(i);
      values[i] = high ? register_max(reg, config) : register_min(reg, config);
    }
    stage.set(values);
    stage.project_and_resolve(stage.items(Pattern::Corners, 64));
  }
  for (int round = 0; round < 24; ++round) {
    const RegisterValues extreme = extreme_registers(config, stage.random);
    RegisterValues values = scene_registers(config, stage.random);
    const int share = round % 2 == 0 ? 100 : 15;  // all of them, or few enough to stay on the plane
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (stage.random.chance(share)) values[i] = extreme[i];
    }
    stage.set(values);
    stage.project_and_resolve(stage.items(round % 4 < 2 ? Pattern::Corners : Pattern::Columns, 64));
  }
  return stage.finish();
}

/// u, v and the depth step over their ends, one position ulp after the other.
std::vector<Word> border_stream(const HardwareConfig& config) {
  Stage stage(config, 300);
  const std::int64_t one = std::int64_t{1} << config.matrix_frac_bits;
  const std::int64_t code = std::int64_t{1} << (config.position_bits() + 4);
  const std::int64_t far = std::min(register_max(Register::MatrixU1, config), one << config.plane_log2);
  const std::int64_t deep = (std::int64_t{1} << config.depth_bits) - 8;
  for (const std::int64_t start : {std::int64_t{0}, far}) {
    RegisterValues values{};
    values[static_cast<std::size_t>(Register::MatrixUx)] = one / 2;
    values[static_cast<std::size_t>(Register::MatrixVy)] = one / 2;
    values[static_cast<std::size_t>(Register::MatrixDz)] = code;
    values[static_cast<std::size_t>(Register::MatrixU1)] = start - 2 * one;
    values[static_cast<std::size_t>(Register::MatrixV1)] = start - 2 * one;
    values[static_cast<std::size_t>(Register::MatrixD1)] = start == 0 ? -8 * code : deep * code;
    stage.set(values);
    std::vector<VoxelItem> items;
    for (std::uint32_t i = 0; i < 256; ++i) items.push_back({{i % 16, i / 16, (i * 7) % 16}, {1, 1, -3}});
    stage.project_and_resolve(items);
    stage.writer.fence(static_cast<std::uint32_t>(start), true);
  }
  return stage.finish();
}

/// The offset lands beyond every border: largest factor, normals in all directions.
std::vector<Word> far_offset_stream(const HardwareConfig& config) {
  Stage stage(config, 400);
  stage.writer.set_register(Register::OffsetFactor, register_max(Register::OffsetFactor, config));
  stage.project_and_resolve(stage.items(Pattern::Columns, 300));
  stage.project_and_resolve(stage.items(Pattern::Corners, 100));
  return stage.finish();
}

/// Deltas and margins below, on and above their limits. All voxels are in one entry, the offset is none, and
/// the rows give g = (3, 4, -5): the margin test compares delta with the root of MARGIN_SQUARED.
std::vector<Word> threshold_stream(const HardwareConfig& config) {
  Stage stage(config, 450);
  RegisterValues values{};
  const auto at = [&](Register reg) -> std::int64_t& { return values[static_cast<std::size_t>(reg)]; };
  at(Register::MatrixUx) = 3;
  at(Register::MatrixVx) = 4;
  at(Register::MatrixDx) = -5;
  at(Register::MatrixDz) = std::int64_t{1} << (config.position_bits() + 4);
  std::vector<VoxelItem> items;
  for (std::uint32_t depth = 0; depth < 16; ++depth) items.push_back({{0, 0, depth}, {1, 0, 0}});
  for (std::int64_t limit = 0; limit < 16; ++limit) {
    at(Register::DeltaMax) = limit;
    at(Register::MarginSquared) = (15 - limit) * (15 - limit);
    stage.set(values);
    stage.project_and_resolve(items);
  }
  return stage.finish();
}

/// Short commands of changing kind: every command is a barrier for the next.
std::vector<Word> barrier_stream(const HardwareConfig& config) {
  Stage stage(config, 500);
  const auto items = stage.items(Pattern::Burst, 120);
  for (std::size_t i = 0; i + 3 <= items.size(); i += 3) {
    stage.project_and_resolve(std::span(items).subspan(i, 1 + i % 3));
    if (i % 9 == 0) stage.writer.clear_plane();
    if (i % 12 == 0) stage.writer.fence(static_cast<std::uint32_t>(i), false);
    if (i % 15 == 0) stage.writer.read_plane(0, 2);
    stage.writer.set_register(Register::DeltaShift, static_cast<std::int64_t>(i % 12));
  }
  return stage.finish();
}

/// More clears than a generation tag has values, with a trace of each to be forgotten.
std::vector<Word> clear_stream(const HardwareConfig& config) {
  Stage stage(config, 600);
  const auto items = stage.items(Pattern::Columns, 520);
  for (std::size_t i = 0; i < 260; ++i) {
    stage.writer.project(std::span(items).subspan(2 * i, 1));
    stage.writer.clear_plane();
    if (i % 16 == 0 && config.en_vpu_offset)
      stage.writer.resolve(std::span(items).subspan(0, 2 * i + 2), true);
  }
  stage.project_and_resolve(items);
  return stage.finish();
}

/// First, last and most entries of one read; entries just written.
std::vector<Word> read_stream(const HardwareConfig& config) {
  Stage stage(config, 700);
  const std::uint32_t entries = std::uint32_t{1} << (2 * config.plane_log2);
  stage.writer.read_plane(0, 256);
  stage.writer.project(stage.items(Pattern::Uniform, 600));
  stage.writer.read_plane(0, 256);
  stage.writer.read_plane(entries / 2 - 128, 256);
  stage.writer.read_plane(entries - 256, 256);
  stage.writer.read_plane(entries - 1, 1);
  stage.writer.clear_plane();
  stage.writer.read_plane(entries / 2 - 128, 256);
  return stage.finish();
}

/// Every command without items, and NOPs with many.
std::vector<Word> empty_stream(const HardwareConfig& config) {
  Stage stage(config, 800);
  auto words = stage.writer.take();
  for (const Op each : {Op::Nop, Op::SetRegisters, Op::ProjectVoxels, Op::ResolveVoxels}) {
    for (int repeat = 0; repeat < 3; ++repeat) words.push_back(encode(Header{op(each), 0, 0, 0}));
  }
  words.push_back(encode(Header{op(Op::SetRegisters), 0, 0, golden::kRegisterCount}));
  words.push_back(encode(Header{op(Op::Nop), 0, 700, 0xFFFFFFFF}));
  for (int i = 0; i < 700; ++i) words.push_back(stage.random.bits());
  stage.project_and_resolve(stage.items(Pattern::Uniform, 5));
  const auto end = stage.finish();
  words.insert(words.end(), end.begin(), end.end());
  return words;
}

/// Each error on its own, and pairs of errors in one header; a fence that reports and one that clears between
/// them.
std::vector<Word> error_stream(const HardwareConfig& config) {
  Stage stage(config, 900);
  auto words = stage.writer.take();
  const std::uint32_t beyond = golden::encode(
      golden::PlaneRange{.first = (std::uint32_t{1} << (2 * config.plane_log2)) - 1, .count = 2});
  std::vector<Header> headers{
      Header{0x05, 0, 3, 0},
      Header{0xFF, 0xFF, 2, 0xFFFFFFFF},
      Header{op(Op::Nop), 1, 2, 0},
      Header{op(Op::Nop), 0x80, 0, 0},
      Header{op(Op::SetRegisters), 0, 1, 32},
      Header{op(Op::SetRegisters), 0, 33, 0},
      Header{op(Op::SetRegisters), 0, 0, 33},
      Header{op(Op::SetRegisters), 0, 2, 0xFFFFFFFF},
      Header{op(Op::SetRegisters), 2, 1, 18},
      Header{op(Op::ClearPlane), 0, 1, 0},
      Header{op(Op::ClearPlane), 4, 1, 0},
      Header{op(Op::Fence), 0, 4, 7},
      Header{op(Op::Fence), 1, 4, 7},
      Header{op(Op::Fence), 2, 0, 7},
      Header{op(Op::Fence), 3, 1, 7},
      Header{op(Op::ReadPlane), 0, 0, beyond},
      Header{op(Op::ReadPlane), 0, 1, 0},
      Header{op(Op::ReadPlane), 1, 0, beyond},
      Header{op(Op::ProjectVoxels), 1, 3, 0},
      Header{op(Op::ResolveVoxels), 2, 3, 0},
      Header{op(Op::ResolveVoxels), 0xFF, 1, 0},
  };
  if (!config.en_perspective) {  // registers that other hardware has
    for (const Header& header :
         {Header{op(Op::SetRegisters), 0, 1, 18}, Header{op(Op::SetRegisters), 0, 19, 0},
          Header{op(Op::SetRegisters), 0, 0, 32}, Header{op(Op::SetRegisters), 0, 4, 16}})
      headers.push_back(header);
  }
  for (std::size_t i = 0; i < headers.size(); ++i) {
    words.push_back(encode(headers[i]));
    for (int item = 0; item < headers[i].count; ++item) words.push_back(stage.random.bits());
    const auto tag = static_cast<std::uint32_t>(i);
    words.push_back(encode(Header{op(Op::Fence), static_cast<std::uint8_t>(i % 2), 0, tag}));
  }
  stage.project_and_resolve(stage.items(Pattern::Columns, 20));
  const auto end = stage.finish();
  words.insert(words.end(), end.begin(), end.end());
  return words;
}

}  // namespace

std::vector<DirectedStream> directed_streams(const HardwareConfig& config) {
  static constexpr std::array<const char*, kPatternCount> kNames{"uniform", "columns", "burst",  "ties",
                                                                 "sheet",   "corners", "grazing"};
  std::vector<DirectedStream> streams;
  streams.reserve(kPatternCount + 9);
  for (int i = 0; i < kPatternCount; ++i) {
    streams.push_back({kNames[static_cast<std::size_t>(i)], pattern_stream(config, static_cast<Pattern>(i))});
  }
  streams.push_back({"extreme_registers", extreme_stream(config)});
  streams.push_back({"borders", border_stream(config)});
  streams.push_back({"far_offset", far_offset_stream(config)});
  streams.push_back({"thresholds", threshold_stream(config)});
  streams.push_back({"barriers", barrier_stream(config)});
  streams.push_back({"clears", clear_stream(config)});
  streams.push_back({"reads", read_stream(config)});
  streams.push_back({"empty_commands", empty_stream(config)});
  streams.push_back({"errors", error_stream(config)});
  if (config.en_perspective) {
    for (DirectedStream& stream : perspective_directed_streams(config)) streams.push_back(std::move(stream));
  }
  if (!config.en_slb) return streams;
  for (DirectedStream& stream : slb_directed_streams(config)) streams.push_back(std::move(stream));
  return streams;
}

}  // namespace gnomon::stimulus
