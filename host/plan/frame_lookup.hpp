// SPDX-License-Identifier: Apache-2.0
// States of voxels asked of the cubic frame buffer, brick by brick. Theory: docs/frame-buffer.md.
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/stream.hpp>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::plan {

/// `config` with a frame buffer of a layer for each of `lights` (at least 1) lights. Fails where that is more
/// than there can be: one line naming the setting, what it would take and what is allowed.
Result<golden::HardwareConfig> with_frame_buffer(golden::HardwareConfig config, std::size_t lights);

/// The bricks of 4 x 4 x 4 voxels that hold some voxels, each asked for once.
class FrameLookup {
 public:
  /// `which`: numbers of voxels of `voxels`. `config` is the hardware's; the grid must fit it.
  FrameLookup(const voxel::VoxelSet& voxels, std::span<const std::uint32_t> which,
              const golden::HardwareConfig& config);

  std::size_t bricks() const { return bricks_; }
  std::size_t voxels() const { return places_.size(); }
  /// Result words that answer it.
  std::size_t words() const;

  void write(golden::StreamWriter& writer, std::uint32_t layer) const;
  /// States in the order of `which`, out of exactly the words that answer it.
  std::vector<golden::VoxelState> states(std::span<const golden::Word> answer) const;

 private:
  struct Place {
    std::uint32_t brick, in_brick;
  };
  std::vector<std::uint32_t> asked_;  ///< bricks by number, ascending
  std::vector<Place> places_;         ///< of each voxel: which of those, and where in it
  std::size_t bricks_ = 0;
  golden::HardwareConfig config_;
};

/// The states that `lookups` asked for, one after the other, among `results`, which may hold other words too.
/// Fails if there are more or fewer, or an error word among them.
Result<std::vector<std::vector<golden::VoxelState>>> frame_states(
    std::span<const golden::Word> results, std::span<const FrameLookup* const> lookups);

}  // namespace gnomon::plan
