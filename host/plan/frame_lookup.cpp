// SPDX-License-Identifier: Apache-2.0
// Which bricks, and where each voxel is in them.
#include "host/plan/frame_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace gnomon::plan {
namespace frame = golden::frame;

namespace {

constexpr int kBrickLog2 = 2;

frame::Cell cell_of(const voxel::Voxel& voxel) {
  return {voxel.x, voxel.y, voxel.z};
}

std::uint32_t brick_of(const frame::Cell& cell, int axis_bits) {
  return (cell.z >> kBrickLog2) << (2 * axis_bits) | (cell.y >> kBrickLog2) << axis_bits |
         cell.x >> kBrickLog2;
}

/// Which of all bricks are asked for, as bits, and how many before each word of them.
class BrickMap {
 public:
  explicit BrickMap(int axis_bits) : bits_((std::size_t{1} << (3 * axis_bits)) / 64 + 1) {}

  void add(std::uint32_t brick) { bits_[brick / 64] |= std::uint64_t{1} << (brick % 64); }

  /// All that were added, ascending; rank() works from then on.
  std::vector<std::uint32_t> list() {
    before_.resize(bits_.size());
    std::vector<std::uint32_t> bricks;
    for (std::size_t word = 0; word < bits_.size(); ++word) {
      before_[word] = static_cast<std::uint32_t>(bricks.size());
      for (std::uint64_t rest = bits_[word]; rest != 0; rest &= rest - 1)
        bricks.push_back(
            static_cast<std::uint32_t>(word * 64 + static_cast<unsigned>(std::countr_zero(rest))));
    }
    return bricks;
  }

  std::uint32_t rank(std::uint32_t brick) const {
    const std::uint64_t below = bits_[brick / 64] & ((std::uint64_t{1} << (brick % 64)) - 1);
    return before_[brick / 64] + static_cast<std::uint32_t>(std::popcount(below));
  }

 private:
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> before_;
};

}  // namespace

Result<golden::HardwareConfig> with_frame_buffer(golden::HardwareConfig config, std::size_t lights) {
  config.en_frame_buffer = true;
  config.frame_layers_log2 = static_cast<int>(std::bit_width(std::max<std::size_t>(lights, 1) - 1));
  if (!config.frame_config().check()) return config;
  const double gib =
      0x1p-32 * static_cast<double>(lights) * static_cast<double>(1ULL << (3 * config.voxel_bits));
  return fail(
      fmt::format("frame_buffer=on would take {:.3g} GiB of states for {} light{} at {}^3 voxels; it holds "
                  "at most 2 GiB and 8 "
                  "lights: set frame_buffer=off, or a smaller res",
                  gib, lights, lights == 1 ? "" : "s", 1 << config.voxel_bits));
}

FrameLookup::FrameLookup(const voxel::VoxelSet& voxels, std::span<const std::uint32_t> which,
                         const golden::HardwareConfig& config)
    : config_(config) {
  const int axis_bits = config.voxel_bits - kBrickLog2;
  BrickMap map(axis_bits);
  for (const std::uint32_t v : which) map.add(brick_of(cell_of(voxels.voxels[v]), axis_bits));
  asked_ = map.list();
  bricks_ = asked_.size();
  places_.reserve(which.size());
  for (const std::uint32_t v : which) {
    const frame::Cell cell = cell_of(voxels.voxels[v]);
    places_.push_back({map.rank(brick_of(cell, axis_bits)), frame::place_in_brick(cell)});
  }
}

std::size_t FrameLookup::words() const {
  return bricks_ * frame::kBrickWords;
}

void FrameLookup::write(golden::StreamWriter& writer, std::uint32_t layer) const {
  const int axis_bits = config_.voxel_bits - kBrickLog2, shift = config_.voxel_frac_bits + kBrickLog2;
  const std::uint32_t mask = (std::uint32_t{1} << axis_bits) - 1;
  std::vector<golden::VoxelItem> items(asked_.size());
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const std::uint32_t b = asked_[i];
    items[i].position = {(b & mask) << shift, (b >> axis_bits & mask) << shift,
                         b >> (2 * axis_bits) << shift};
  }
  writer.look_up(items, layer, true);
}

std::vector<golden::VoxelState> FrameLookup::states(std::span<const golden::Word> answer) const {
  std::vector<golden::VoxelState> states;
  states.reserve(places_.size());
  for (const Place& place : places_) {
    const golden::Word word =
        answer[place.brick * frame::kBrickWords + place.in_brick / frame::kStatesPerWord];
    states.push_back(
        static_cast<golden::VoxelState>(word >> (2 * (place.in_brick % frame::kStatesPerWord)) & 3));
  }
  return states;
}

Result<std::vector<std::vector<golden::VoxelState>>> frame_states(
    std::span<const golden::Word> results, std::span<const FrameLookup* const> lookups) {
  std::vector<golden::Word> words;
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    if (golden::result_code(result->word) == golden::ResultCode::Error)
      return fail("the hardware refused a command: " + golden::describe_result(result->word));
    if (result->word >> 56 == frame::kStatesCode) words.push_back(result->word);
  }
  std::size_t expected = 0;
  for (const FrameLookup* lookup : lookups) expected += lookup->words();
  if (words.size() != expected)
    return fail(fmt::format("the hardware returned {} words of states, expected {}", words.size(), expected));
  std::vector<std::vector<golden::VoxelState>> states;
  std::span<const golden::Word> rest = words;
  for (const FrameLookup* lookup : lookups) {
    states.push_back(lookup->states(rest.first(lookup->words())));
    rest = rest.subspan(lookup->words());
  }
  return states;
}

}  // namespace gnomon::plan
