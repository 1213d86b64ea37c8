// SPDX-License-Identifier: Apache-2.0
// Random builds, registers and voxels for the property tests.
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/vpu.hpp>
#include <vector>

#include "tests/support/random.hpp"
#include "tests/support/scene_registers.hpp"

namespace gnomon::golden_test {

enum class Content { Scene, Mixed, Extreme };

struct Case {
  golden::HardwareConfig config;
  stimulus::RegisterValues registers{};
  std::vector<golden::VoxelItem> items;
};

/// Any legal build with a plane of at most 2^max_plane_log2 entries a side.
golden::HardwareConfig any_config(stimulus::Random& random, int max_plane_log2 = 12);

/// Registers of a scene, of a scene with some at their ends, or all at their ends.
stimulus::RegisterValues any_registers(const golden::HardwareConfig& config, Content content,
                                       stimulus::Random& random);

/// A case from a seed: any build, `count` items of any pattern. Scene planes are small, so that entries are
/// shared.
Case any_case(std::uint64_t seed, Content content, std::size_t count);

/// The unit with these registers.
golden::Vpu make_vpu(const golden::HardwareConfig& config, const stimulus::RegisterValues& registers);

}  // namespace gnomon::golden_test
