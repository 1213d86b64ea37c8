// SPDX-License-Identifier: Apache-2.0
// Polygons to try the silhouette-line buffer on, all made here from a seed.
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/formats.hpp>
#include <string>
#include <vector>

namespace gnomon::golden::slb::testing {

/// A small generator with the same sequence everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  double unit();  ///< 0 <= u < 1
  double between(double low, double high);
  std::int64_t integer(std::int64_t low, std::int64_t high);  ///< both included

 private:
  std::uint64_t state_;
};

struct Point {
  double x = 0, y = 0;  ///< pixels
};
using Polygon = std::vector<Point>;  ///< interior on the left
using Loop = std::vector<Vertex>;
using Object = std::vector<Loop>;  ///< one flat caster
using Scene = std::vector<Object>;

/// Nearest sub-pixel lattice points.
Loop quantise(const Polygon& polygon, const SlbConfig& config, std::uint32_t depth = 0);
double perimeter(const Scene& scene, const SlbConfig& config);

/// A named family of scenes; `instance` varies place, angle and form.
struct Shape {
  std::string name;
  Scene (*make)(const SlbConfig&, std::uint64_t instance);
};
const std::vector<Shape>& shapes();
const Shape& shape(const std::string& name);

Polygon star(Random& random, int corners, double low, double high, Point centre);

}  // namespace gnomon::golden::slb::testing
