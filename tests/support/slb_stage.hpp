// SPDX-License-Identifier: Apache-2.0
// A stream under construction, with objects, queries and reads of the silhouette-line buffer in a line each.
#pragma once

#include <cstdint>
#include <gnomon/golden/stream.hpp>
#include <span>
#include <vector>

#include "tests/golden/slb/shapes.hpp"

namespace gnomon::stimulus {

struct SlbStage {
  using Loop = golden::slb::testing::Loop;
  using Polygon = golden::slb::testing::Polygon;  ///< pixels

  explicit SlbStage(const golden::HardwareConfig& hardware);

  Loop loop(const Polygon& polygon, std::uint32_t depth = 0) const { return quantise(polygon, slb, depth); }
  static Polygon rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }
  /// A whole flat object.
  void object(std::uint8_t id, std::uint32_t depth, const std::vector<Polygon>& polygons);
  /// Points on a lattice over the square around (x, y), some of them whole pixels, at depths around `depth`.
  void ask(double x, double y, double radius, std::uint32_t depth, std::uint32_t bias = 0);
  void ask_everywhere(std::uint32_t depth) { ask(side / 2.0, side / 2.0, 0.6 * side, depth); }
  /// The entries around the middle of the plane, and the last ones.
  void read();
  /// Words that the writer would refuse, after what it has written.
  void raw(const golden::Header& header, std::span<const golden::Word> items = {});
  /// The stream, with a FENCE that clears the sticky flags and one that shows it.
  std::vector<golden::Word> finish();

  golden::HardwareConfig config;
  golden::slb::SlbConfig slb;
  int side;
  golden::StreamWriter writer;

 private:
  std::vector<golden::Word> words_;
};

}  // namespace gnomon::stimulus
