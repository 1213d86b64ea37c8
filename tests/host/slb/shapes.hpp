// SPDX-License-Identifier: Apache-2.0
// The golden tests' polygons as the host has them.
#pragma once

#include <cmath>
#include <gnomon/golden/config.hpp>

#include "host/slb/loop_scene.hpp"
#include "tests/golden/slb/shapes.hpp"

namespace gnomon::slb::test {

/// All objects at depth 0.25; coordinates are the lattice points of `scene`.
inline LoopScene from_golden(const golden::slb::testing::Scene& scene, const golden::slb::SlbConfig& config) {
  LoopScene casters;
  for (const auto& object : scene) {
    FlatCaster caster{0.25, {}};
    for (const auto& vertices : object) {
      Loop loop;
      loop.reserve(vertices.size());
      for (const golden::slb::Vertex& v : vertices) {
        loop.emplace_back(std::ldexp(static_cast<double>(v.x), -config.subpixel_bits),
                          std::ldexp(static_cast<double>(v.y), -config.subpixel_bits));
      }
      caster.loops.push_back(std::move(loop));
    }
    casters.push_back(std::move(caster));
  }
  return casters;
}

/// A 64 pixel plane with F = S, fine vertices and queries.
inline golden::slb::SlbConfig small_plane(int frac_bits) {
  golden::slb::SlbConfig config;
  config.frac_bits = frac_bits;
  config.slope_bits = frac_bits;
  config.plane_log2 = 6;
  config.subpixel_bits = 12;
  config.query_bits = 14;
  return config;
}

/// Hardware with that buffer.
inline golden::HardwareConfig hardware(const golden::slb::SlbConfig& slb) {
  golden::HardwareConfig config;
  config.en_slb = true;
  config.slb_plane_log2 = slb.plane_log2;
  config.frac_bits = slb.frac_bits;
  config.slope_bits = slb.slope_bits;
  config.frags_per_pixel = slb.frags;
  config.depth_bits = slb.depth_bits;
  config.subpixel_bits = slb.subpixel_bits;
  config.query_bits = slb.query_bits;
  config.slb_rounding = slb.rounding;
  return config;
}

}  // namespace gnomon::slb::test
