// SPDX-License-Identifier: Apache-2.0
// One function a situation.
#include "tests/support/perspective_directed.hpp"

#include <algorithm>
#include <array>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/stream.hpp>
#include <span>

#include "tests/support/box_size.hpp"
#include "tests/support/perspective_registers.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Register;
using golden::StreamWriter;
using golden::VoxelItem;
using golden::Word;

/// A writer that leaves out what the hardware cannot do, with the registers it has set.
struct Stage {
  Stage(const HardwareConfig& hardware, std::uint64_t seed)
      : config(hardware), random(seed), writer(hardware) {}

  void set(const AllRegisters& values) {
    registers = values;
    writer.set_registers(Register::MatrixUx, registers);
  }
  void set(Register reg, std::int64_t value) {
    registers[static_cast<std::size_t>(reg)] = value;
    writer.set_register(reg, value);
  }
  std::vector<VoxelItem> items(Pattern pattern, std::size_t count) {
    return voxel_pattern(pattern, count, pattern_registers(registers, config), config, random);
  }
  void both_passes(std::span<const VoxelItem> voxels) {
    writer.project(voxels);
    if (config.en_vpu_offset) {
      writer.resolve(voxels, false);
      writer.resolve(voxels, true);
    }
    if (config.en_vpu_topology) topology(voxels);
  }
  std::vector<Word> finish() {
    writer.fence(0xF1A15, true);
    return writer.take();
  }

  HardwareConfig config;
  Random random;
  StreamWriter writer;
  AllRegisters registers{};

 private:
  /// The voxel moved by up to `reach` ulps on each axis.
  VoxelItem beside(VoxelItem voxel, std::int64_t reach) {
    const std::int64_t last = (std::int64_t{1} << config.position_bits()) - 1;
    for (std::uint32_t& c : voxel.position)
      c = static_cast<std::uint32_t>(std::clamp<std::int64_t>(c + random.between(-reach, reach), 0, last));
    return voxel;
  }

  /// Of all quads those whose boxes together are not more than the default plane: near the light small quads
  /// cover much of a larger one, an entry a cycle.
  void keep_those_with_room(std::vector<std::array<VoxelItem, 4>>& quads) const {
    const auto light = projection_registers(registers, config);
    std::int64_t left = std::int64_t{1} << 18;
    std::erase_if(quads, [&](const std::array<VoxelItem, 4>& quad) {
      std::array<Word, 4> corners{};
      std::transform(quad.begin(), quad.end(), corners.begin(),
                     [&](const VoxelItem& corner) { return encode(corner, config); });
      const std::int64_t size = box_size(corners, light, config.topology_config());
      if (size > left) return true;
      left -= size;
      return false;
    });
  }

  /// Small quads around some of the voxels; few have a corner anywhere, for boxes as large as the plane cost
  /// as many cycles.
  void topology(std::span<const VoxelItem> voxels) {
    std::vector<std::array<VoxelItem, 4>> quads;
    const std::int64_t reach = (std::int64_t{1} << config.position_bits()) / 24 + 1;
    const std::size_t step = std::max<std::size_t>(1, voxels.size() / 40);
    for (std::size_t i = 0; i < voxels.size(); i += step) {
      quads.push_back({beside(voxels[i], reach), beside(voxels[i], reach), beside(voxels[i], reach),
                       beside(voxels[i], reach)});
      if (random.chance(4)) quads.back()[3] = random.pick(voxels);
    }
    keep_those_with_room(quads);
    const bool in_perspective =
        (registers[static_cast<std::size_t>(Register::Projection)] & golden::kProjectionPerspective) != 0;
    const int bits = in_perspective ? golden::perspective::kClearanceBits : config.depth_bits;
    writer.clear_lists();
    writer.put_quads(quads);
    for (const bool sorted : {false, true}) {
      const auto clearance = static_cast<std::uint32_t>(
          random.chance(40) ? 0 : random.between(0, (std::int64_t{1} << random.between(1, bits)) - 1));
      writer.resolve_topology(voxels, random.chance(50), clearance, sorted);
    }
    writer.read_lists(0, 256);
  }
};

std::vector<Word> pattern_stream(const HardwareConfig& config) {
  Stage stage(config, 1100);
  for (int pattern = 0; pattern < kPatternCount; ++pattern) {
    for (int light = 0; light < 3; ++light) {
      stage.set(perspective_registers(config, stage.random));
      stage.both_passes(stage.items(static_cast<Pattern>(pattern), 120));
      stage.writer.clear_plane();
    }
  }
  return stage.finish();
}

/// Registers at their ends, some of them or all.
std::vector<Word> extreme_stream(const HardwareConfig& config) {
  Stage stage(config, 1200);
  for (int round = 0; round < 36; ++round) {
    static constexpr std::array kShares{5, 15, 40, 100};
    const int share = kShares[static_cast<std::size_t>(round) % kShares.size()];
    stage.set(extreme_perspective_registers(config, share, stage.random));
    stage.both_passes(stage.items(round % 3 == 0 ? Pattern::Columns : Pattern::Corners, 48));
    stage.writer.fence(static_cast<std::uint32_t>(round), true);
  }
  return stage.finish();
}

/// A light that looks along +z from the height `z`, in whole ulps; w grows by 2^-P an ulp. At the distance d
/// an entry is d / entries ulps wide.
AllRegisters from_below(const HardwareConfig& config, std::int64_t z, std::int64_t entries) {
  AllRegisters values{};
  const auto at = [&](Register reg) -> std::int64_t& { return values[static_cast<std::size_t>(reg)]; };
  const int f = config.matrix_frac_bits, p = config.position_bits();
  const std::int64_t middle = 8;
  at(Register::Projection) = golden::kProjectionPerspective;
  at(Register::MatrixWz) = std::int64_t{1} << f;
  at(Register::MatrixW1) = -z * (std::int64_t{1} << f);
  at(Register::MatrixUx) = at(Register::MatrixVy) = std::max<std::int64_t>(entries << f >> p, 1);
  at(Register::MatrixU1) = at(Register::MatrixV1) = -middle * at(Register::MatrixUx);
  at(Register::CentreU) = at(Register::CentreV) = config.plane_side() / 2;
  at(Register::KeyScale) = std::int64_t{1} << std::max(0, config.depth_bits + 4 - p + 2);
  at(Register::KeyLimit) = std::int64_t{1} << (config.depth_bits + 4);
  at(Register::LightX) = at(Register::LightY) = 8 * middle + 4;
  at(Register::LightZ) = 8 * z + 4;
  at(Register::OffsetFactor) = 1 << 15;
  at(Register::DeltaMax) = register_max(Register::DeltaMax, config);
  return values;
}

/// A block of 16 x 16 x 16 ulps, all of it or every third voxel.
std::vector<VoxelItem> block(std::uint32_t step) {
  std::vector<VoxelItem> items;
  for (std::uint32_t i = 0; i < 4096; i += step)
    items.push_back({{i % 16, i / 16 % 16, i / 256}, {static_cast<std::int32_t>(i % 3) - 1, 1, -3}});
  return items;
}

/// One ulp after the other through the light's plane and the nearest w, with the light inside the block.
std::vector<Word> near_stream(const HardwareConfig& config) {
  Stage stage(config, 1300);
  for (const std::int64_t near : {0, 1, 2, 5, 9}) {
    for (const std::int64_t z : {-1, 0, 7, 14, 15}) {
      stage.set(from_below(config, z, 16));
      stage.set(Register::WNear, near);
      stage.both_passes(block(23));
      stage.writer.fence(static_cast<std::uint32_t>(near), true);
    }
  }
  return stage.finish();
}

/// The cone's radius below, on and above the distance of a voxel: x entries from the axis at w = 2^-P * 8.
std::vector<Word> cone_stream(const HardwareConfig& config) {
  Stage stage(config, 1400);
  for (const std::int64_t radius : {0, 1, 3, 5}) {
    for (const std::int64_t more : {-1, 0, 1}) {
      stage.set(from_below(config, -8, 8));
      stage.set(Register::Projection, golden::kProjectionPerspective | golden::kProjectionCone);
      stage.set(Register::ConeSquared, std::max<std::int64_t>(0, (radius * radius << 16) + more));
      stage.both_passes(block(13));
    }
  }
  return stage.finish();
}

/// The plane's borders and the depth range's, one position ulp after the other.
std::vector<Word> border_stream(const HardwareConfig& config) {
  Stage stage(config, 1500);
  const std::int64_t half = config.plane_side() / 2;
  for (const std::int64_t centre :
       {std::int64_t{0}, 2 * half, 2 * half - 1, -half, 4 * half - 1, -4 * half}) {
    for (const int shift : {0, 1, 3}) {
      stage.set(from_below(config, -4, 8));
      stage.set(Register::CentreU, centre);
      stage.set(Register::CentreV, half);
      const std::int64_t scale = std::int64_t{1}
                                 << std::max(0, config.depth_bits + 4 - config.position_bits() + shift);
      stage.set(Register::KeyScale, scale);
      stage.set(Register::KeyLimit, scale << std::min(config.position_bits() - 3, 6));
      stage.both_passes(block(19));
      stage.writer.fence(static_cast<std::uint32_t>(shift), true);
    }
  }
  return stage.finish();
}

/// One projection after the other with the same other registers, and some of these changed in between. w is 1
/// to 1.25, so that both projections see the scene on the plane.
std::vector<Word> switch_stream(const HardwareConfig& config) {
  Stage stage(config, 1600);
  const RegisterValues base = scene_registers(config, stage.random);
  AllRegisters values = from_below(config, 0, 1);
  std::copy(base.begin(), base.end(), values.begin());
  const auto at = [&](Register reg) -> std::int64_t& { return values[static_cast<std::size_t>(reg)]; };
  at(Register::MatrixWz) = std::int64_t{1} << (config.matrix_frac_bits - 2);
  at(Register::MatrixW1) = std::int64_t{1} << (config.matrix_frac_bits + config.position_bits());
  at(Register::CentreU) = at(Register::CentreV) = 0;
  at(Register::KeyScale) = std::int64_t{5} << (config.depth_bits + 4);
  at(Register::KeyLimit) = at(Register::KeyScale) - 1;
  at(Register::ConeSquared) = std::int64_t{1} << (2 * config.plane_log2 + 15);
  stage.set(values);
  const auto items = voxel_pattern(Pattern::Columns, 240, base, config, stage.random);
  for (std::size_t i = 0; i + 8 <= items.size(); i += 4) {
    stage.set(Register::Projection, static_cast<std::int64_t>(i / 4 % 4));
    stage.both_passes(std::span(items).subspan(i, 1 + i % 8));
    if (i % 12 == 0) stage.set(Register::WNear, stage.random.between(0, 1 << config.position_bits()));
    if (i % 20 == 0) stage.set(Register::CentreU, stage.random.between(-3, 3));
  }
  stage.set(Register::Projection, golden::kProjectionPerspective);
  stage.both_passes(items);
  return stage.finish();
}

}  // namespace

std::vector<DirectedStream> perspective_directed_streams(const HardwareConfig& config) {
  return {{"perspective_patterns", pattern_stream(config)}, {"perspective_extremes", extreme_stream(config)},
          {"perspective_near", near_stream(config)},        {"perspective_cone", cone_stream(config)},
          {"perspective_borders", border_stream(config)},   {"perspective_switch", switch_stream(config)}};
}

}  // namespace gnomon::stimulus
