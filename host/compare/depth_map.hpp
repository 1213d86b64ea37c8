// SPDX-License-Identifier: Apache-2.0
// Plain shadow map and percentage-closer filtering as software models. Theory: docs/techniques.md.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host/base/light_plane.hpp"

namespace gnomon::compare {

/// What the light's ray through a texel's centre meets.
struct Sheets {
  double nearest = 0;       ///< voxels from where the ray starts; of no meaning if there is none
  std::uint32_t count = 0;  ///< sheets that are drawn
};

/// A square of texels over a part of the light's plane, and the range of its depth codes.
struct MapPlan {
  LightPlane plane;
  double nearest = 0;          ///< voxels along the light's way: the depth of code 0
  double codes_per_voxel = 1;  ///< greater than 0
  int depth_bits = 20;         ///< 1..31

  /// DEPTH_BITS padded to whole bytes.
  std::uint64_t texel_bytes() const { return (static_cast<std::uint64_t>(depth_bits) + 7) / 8; }
  std::uint64_t texels() const {
    return static_cast<std::uint64_t>(plane.side) * static_cast<std::uint64_t>(plane.side);
  }
  std::uint64_t memory_bits() const { return texels() * texel_bytes() * 8; }
};

/// The plan's map with `side` texels on each side, over the same area.
MapPlan with_side(MapPlan plan, int side);

/// The largest side whose texels fit into `bits`; at least 1.
int side_within(std::uint64_t bits, std::uint64_t texel_bytes);

/// Cycles and bytes of one map, in the order of the passes (docs/techniques.md, "Costs").
struct MapCosts {
  std::uint64_t clear_cycles = 0, draw_cycles = 0, query_cycles = 0;
  std::uint64_t bytes_read = 0, bytes_written = 0;
};

class DepthMap {
 public:
  /// What a ray from `start` along the light's way meets.
  using Cast = std::function<Sheets(const Vec3& start)>;

  /// Draws the map with one ray a texel, on all cores; `cast` must be thread-safe. Throws
  /// std::invalid_argument for a plan without texels.
  DepthMap(const MapPlan& plan, const Cast& cast);

  /// `facing`: cosine between normal and light; a surface that faces away is in shadow. `kernel`: texels read
  /// on each axis, at least 1.
  bool in_shadow(const Vec3& point, double facing, int kernel) const;
  /// A texel's code; all ones where it is empty.
  std::uint32_t code(int x, int y) const;
  std::uint32_t empty_code() const { return (std::uint32_t{1} << plan_.depth_bits) - 1; }
  /// Sheets by texels that they were drawn into.
  std::uint64_t drawn() const { return drawn_; }
  /// Of clearing and drawing the map and asking `queries` points with this kernel.
  MapCosts costs(std::uint64_t queries, int kernel) const;
  const MapPlan& plan() const { return plan_; }

 private:
  std::uint32_t code_of(double depth) const;
  std::uint64_t draw_row(int y, const Cast& cast);

  MapPlan plan_;
  std::vector<std::uint32_t> codes_;
  std::uint64_t drawn_ = 0;
};

}  // namespace gnomon::compare
