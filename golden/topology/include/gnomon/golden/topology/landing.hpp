// SPDX-License-Identifier: Apache-2.0
// Where corners and beams land on the plane (docs/vpu-topology.md, "Put" and "Resolve").
#pragma once

#include <cstdint>
#include <gnomon/golden/perspective/view.hpp>
#include <gnomon/golden/topology/config.hpp>

namespace gnomon::golden::topology {

/// A projected point or direction before any narrowing: u, v in entries with MATRIX_FRAC_BITS fraction bits,
/// d in depth codes with P + 4.
struct Projected {
  std::int64_t u = 0, v = 0, d = 0;
};

/// A corner of a quad.
struct Corner {
  std::int64_t u = 0, v = 0;  ///< sub-entries, saturated to two planes on either side
  std::uint32_t depth = 0;    ///< code, saturated to 0..2^DEPTH_BITS - 2
  bool saturated = false;     ///< the depth was
};

/// The beam of a voxel: a point of the plane and the depth where it starts.
struct Beam {
  std::int64_t u = 0, v = 0;  ///< sub-entries
  std::uint32_t depth = 0;
  bool on_plane = false;
};

Corner land_corner(const Projected& point, const TopologyConfig& config);
/// `normal` is the projected normal, turned to the light; `factor` is OFFSET_FACTOR.
Beam land_beam(const Projected& point, const Projected& normal, std::int64_t factor,
               const TopologyConfig& config);

/// The same in perspective. `sight` is not behind.
Corner land_corner(const perspective::Sight& sight, const TopologyConfig& config);
/// With the clearance in the depth: compare it with none.
Beam land_beam(const perspective::Moved& moved, const TopologyConfig& config);

}  // namespace gnomon::golden::topology
