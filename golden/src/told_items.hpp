// SPDX-License-Identifier: Apache-2.0
// What the cycle model asks of items beside their words: the lines of the plane that they touch.
#pragma once

#include <gnomon/golden/slb/unit.hpp>
#include <gnomon/golden/vpu.hpp>
#include <span>
#include <vector>

#include "cycles/cycle_model.hpp"

namespace gnomon::golden {

/// The line of a plane behind a cache that holds the point's entry: a tile of 4 x 4 entries, tiles in Morton
/// order (docs/cache.md). Of a point off the plane that of the entry with its low bits, which the hardware
/// reads too.
std::uint32_t line_of(const PlanePoint& point, int plane_log2);

/// Items of RESOLVE_VOXELS with the flags of their command.
std::vector<cycles::Item> resolved_items(const Vpu& vpu, const HardwareConfig& config,
                                         std::span<const Word> words, std::uint8_t flags);

/// Items of QUERY: the pixel that each reads.
std::vector<cycles::Item> queried_items(const slb::SlbConfig& config, std::span<const Word> words);

/// Gives items of COVER to the unit one by one, to see which of them go to the memory, and which change it.
/// `swept`: by the FILL before.
cycles::ItemWork take_covers(slb::SlbUnit& unit, const slb::FillSweep& swept, std::span<const Word> items);

}  // namespace gnomon::golden
