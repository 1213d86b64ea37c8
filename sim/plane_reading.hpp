// SPDX-License-Identifier: Apache-2.0
// The plane by READ_PLANE commands.
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <span>
#include <vector>

namespace gnomon::sim {

/// Commands that read every entry of the plane.
std::vector<golden::Word> plane_commands(const golden::HardwareConfig& config);

/// What golden::Engine::read_plane gives, from the answers to those commands.
std::vector<std::uint32_t> plane_of(const golden::HardwareConfig& config,
                                    std::span<const golden::Word> results);

}  // namespace gnomon::sim
