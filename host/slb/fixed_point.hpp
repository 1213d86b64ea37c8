// SPDX-License-Identifier: Apache-2.0
// From the numbers of a file to the unit's integers, each rounding under its name (docs/slb-cli.md,
// "Rounding").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/query.hpp>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/slb/loop_scene.hpp"

namespace gnomon::slb {

/// Depth codes of 0..1 are 0..2^DEPTH_BITS - 2. A caster's is rounded up.
std::uint32_t caster_depth(double depth, const golden::slb::SlbConfig& config);
/// A receiver's is rounded down; below 0 it is 0, beyond 1 it lies behind every caster.
std::uint32_t receiver_depth(double z, const golden::slb::SlbConfig& config);

/// Position floored to 2^-QUERY_BITS pixels (the unit reads it half a unit farther); what lies off the plane
/// stays off it.
golden::slb::QueryPoint to_query(const Receiver& receiver, const golden::slb::SlbConfig& config);

/// The nearest points of the vertex lattice, 2^-SUBPIXEL_BITS pixels; halves go up.
struct FixedCaster {
  std::uint32_t depth = 0;
  std::vector<std::vector<golden::slb::Vertex>> loops;
};

/// Fails for a vertex outside the guard band, -side <= x, y < 2 side; the error names object, loop and
/// vertex.
Result<std::vector<FixedCaster>> to_fixed(const LoopScene& scene, const golden::slb::SlbConfig& config);

}  // namespace gnomon::slb
