// SPDX-License-Identifier: Apache-2.0
// Command programs for topology mode: single commands, and random streams.
#pragma once

#include "tests/golden/topology/scenes.hpp"
#include "tests/rtl/topology/outcome.hpp"

namespace gnomon::rtl_test::topology {

using golden::topology::Item;
using test::Quad;

Command clear_lists();
Command set(const ProjectionRegisters& registers);
Command put(std::span<const Quad> quads, const TopologyConfig& config);
Command resolve(std::span<const Item> voxels, const TopologyConfig& config, std::uint8_t flags,
                std::uint32_t clearance);
/// All entries, in commands of at most 256.
Program read_all(const TopologyConfig& config);

/// A directional light, `entries` plane entries and `codes` depth codes a voxel; `direction` points where the
/// light goes. The grid's middle falls on the plane's.
ProjectionRegisters light(const TopologyConfig& config, const std::array<double, 3>& direction,
                          double entries, double codes);
/// As many entries and codes as let the grid fill the plane and half of the depths.
ProjectionRegisters light(const TopologyConfig& config, const std::array<double, 3>& direction);
/// Position ulps to an entry, under that light.
int ulps_per_entry(const TopologyConfig& config);

/// Registers of any content that their widths hold.
ProjectionRegisters wild_registers(stimulus::Random& random, const TopologyConfig& config);

/// Clears, quads of all sizes, voxels and reads in random order, under random lights; at the end a look at
/// all entries, if the plane is small.
Program random_program(stimulus::Random& random, const TopologyConfig& config, int commands);

}  // namespace gnomon::rtl_test::topology
