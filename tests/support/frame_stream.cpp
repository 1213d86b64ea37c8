// SPDX-License-Identifier: Apache-2.0
// A random walk through the frame buffer's commands.
#include "tests/support/frame_stream.hpp"

#include <algorithm>
#include <array>
#include <gnomon/golden/stream.hpp>
#include <optional>
#include <span>

#include "tests/support/random.hpp"
#include "tests/support/scene_registers.hpp"

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Keeping;
using golden::StreamWriter;
using golden::VoxelItem;
using golden::Word;

class FrameWalk {
 public:
  FrameWalk(const HardwareConfig& config, std::uint64_t seed)
      : config_(config), random_(seed), writer_(config) {
    writer_.set_registers(golden::Register::MatrixUx, scene_registers(config, random_));
  }

  std::vector<Word> take(int commands) {
    for (int i = 0; i < commands; ++i) one();
    writer_.fence(9, false);
    return writer_.take();
  }

 private:
  void one() {
    const std::vector<VoxelItem> some = items(static_cast<std::size_t>(random_.between(0, 60)));
    switch (random_.between(0, 9)) {
      case 0:
        return random_.chance(30) ? writer_.clear_frame() : writer_.clear_plane();
      case 1:
        return writer_.project(some);
      case 2:
        return put();
      case 3:
      case 4:
        return resolve(some);
      case 5:
      case 6:
        return resolve_topology(some);
      default: {
        const std::uint32_t layer = any_layer();
        return writer_.look_up(some, layer, random_.chance(30));
      }
    }
  }

  void put() {
    if (!config_.en_vpu_topology) return;
    std::vector<std::array<VoxelItem, 4>> quads(static_cast<std::size_t>(random_.between(0, 20)));
    for (auto& quad : quads) {
      const std::vector<VoxelItem> corners = items(4);
      std::copy(corners.begin(), corners.end(), quad.begin());
    }
    writer_.put_quads(quads);
  }

  void resolve(std::span<const VoxelItem> some) {
    if (!config_.en_vpu_offset) return;
    const bool two_sided = random_.chance(50);
    writer_.keep(keeping());
    writer_.resolve(some, two_sided);
  }

  void resolve_topology(std::span<const VoxelItem> some) {
    if (!config_.en_vpu_topology) return;
    const bool two_sided = random_.chance(50);
    const std::int64_t clearance = random_.between(0, std::int64_t{1} << (config_.depth_bits - 9));
    writer_.keep(keeping());
    writer_.resolve_topology(some, two_sided, static_cast<std::uint32_t>(clearance), false);
  }

  std::uint32_t any_layer() {
    return static_cast<std::uint32_t>(random_.between(0, (1 << config_.frame_layers_log2) - 1));
  }

  std::optional<Keeping> keeping() {
    if (random_.chance(20)) return std::nullopt;
    return Keeping{any_layer(), random_.chance(60)};
  }

  /// Crowded, so that places are written and looked up again.
  std::vector<VoxelItem> items(std::size_t count) {
    const std::int64_t last = (std::int64_t{1} << config_.position_bits()) - 1;
    const std::int64_t reach = random_.chance(70) ? last / 3 : last;
    const int most = (1 << (config_.normal_bits - 1)) - 1;
    std::vector<VoxelItem> all(count);
    for (VoxelItem& item : all)
      for (std::size_t i = 0; i < 3; ++i) {
        item.position[i] = static_cast<std::uint32_t>(random_.between(0, reach));
        item.normal[i] = static_cast<std::int32_t>(random_.between(-most, most));
      }
    return all;
  }

  HardwareConfig config_;
  Random random_;
  StreamWriter writer_;
};

}  // namespace

std::vector<Word> frame_stream(const HardwareConfig& config, std::uint64_t seed, int commands) {
  return FrameWalk(config, seed).take(commands);
}

}  // namespace gnomon::stimulus
