// SPDX-License-Identifier: Apache-2.0
// Polygons for displacement measurements and tests.
#include "tests/golden/slb/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace gnomon::golden::slb::testing {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double middle(const SlbConfig& config) {
  return config.side() / 2.0;
}

Scene one(const Polygon& polygon, const SlbConfig& config) {
  return {{quantise(polygon, config)}};
}

Scene random_polygon(const SlbConfig& config, std::uint64_t instance) {
  Random random(instance);
  const double m = middle(config);
  return one(star(random, 24, 0.3 * m, 0.9 * m, {m, m}), config);
}

Scene strip(const SlbConfig& config, std::uint64_t instance, double width) {
  Random random(instance);
  const double m = middle(config), angle = random.between(0, kTurn), length = 0.8 * m;
  const Point centre{m + random.between(-2, 2), m + random.between(-2, 2)};
  const double c = std::cos(angle), s = std::sin(angle);
  Polygon polygon;
  for (const auto& [along, across] :
       {Point{-length, -width / 2}, {length, -width / 2}, {length, width / 2}, {-length, width / 2}})
    polygon.push_back({centre.x + along * c - across * s, centre.y + along * s + across * c});
  return one(polygon, config);
}
Scene strip_1(const SlbConfig& config, std::uint64_t i) {
  return strip(config, i, 1.0);
}
Scene strip_05(const SlbConfig& config, std::uint64_t i) {
  return strip(config, i, 0.5);
}
Scene strip_01(const SlbConfig& config, std::uint64_t i) {
  return strip(config, i, 0.1);
}

/// A smooth closed curve of mean radius 22 in edges of the given length.
Scene smooth(const SlbConfig& config, std::uint64_t instance, int corners) {
  Random random(instance);
  const double m = middle(config), radius = 22.0 / 32.0 * m;
  const double phase2 = random.between(0, kTurn), phase3 = random.between(0, kTurn),
               start = random.between(0, kTurn);
  const Point centre{m + random.between(-1, 1), m + random.between(-1, 1)};
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double t = start + kTurn * i / corners;
    const double r = radius * (1 + 0.12 * std::cos(2 * t + phase2) + 0.05 * std::cos(3 * t + phase3));
    polygon.push_back({centre.x + r * std::cos(t), centre.y + r * std::sin(t)});
  }
  return one(polygon, config);
}
Scene smooth_100(const SlbConfig& config, std::uint64_t i) {
  return smooth(config, i, 100);
}
Scene smooth_05(const SlbConfig& config, std::uint64_t i) {
  return smooth(config, i, 280);
}
Scene smooth_014(const SlbConfig& config, std::uint64_t i) {
  return smooth(config, i, 1000);
}

/// Teeth half a pitch wide and half a pitch high.
Scene gear(const SlbConfig& config, std::uint64_t instance, double pitch) {
  Random random(instance);
  const double m = middle(config), radius = 24.0 / 32.0 * m, start = random.between(0, kTurn);
  const Point centre{m + random.between(-1, 1), m + random.between(-1, 1)};
  const int teeth = static_cast<int>(kTurn * radius / pitch);
  Polygon polygon;
  for (int i = 0; i < teeth; ++i) {
    const double a = start + kTurn * i / teeth, b = start + kTurn * (i + 0.5) / teeth;
    const double low = radius - pitch / 4, high = radius + pitch / 4;
    for (const auto& [angle, r] : {Point{a, low}, {a, high}, {b, high}, {b, low}})
      polygon.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
  }
  return one(polygon, config);
}
Scene gear_5(const SlbConfig& config, std::uint64_t i) {
  return gear(config, i, 5);
}
Scene gear_3(const SlbConfig& config, std::uint64_t i) {
  return gear(config, i, 3);
}
Scene gear_2(const SlbConfig& config, std::uint64_t i) {
  return gear(config, i, 2);
}

/// Both loops hold the corners of the common edges, in opposite order.
Scene sharing(const SlbConfig& config, std::uint64_t instance) {
  Random random(instance);
  const double m = middle(config);
  const Polygon whole = star(random, 24, 0.4 * m, 0.9 * m, {m, m});
  Polygon first(whole.begin(), whole.begin() + 13), second(whole.begin() + 12, whole.end());
  second.push_back(whole.front());
  const Point knee{m + random.between(-4, 4), m + random.between(-4, 4)};
  first.push_back(knee);
  second.push_back(knee);
  return {{quantise(first, config), quantise(second, config)}};
}

Scene overlapping(const SlbConfig& config, std::uint64_t instance) {
  Random random(instance);
  const double m = middle(config), shift = 0.25 * m;
  return {{quantise(star(random, 24, 0.3 * m, 0.7 * m, {m - shift, m}), config),
           quantise(star(random, 24, 0.3 * m, 0.7 * m, {m + shift, m}), config)}};
}

Scene pixel_corners(const SlbConfig& config, std::uint64_t instance) {
  Random random(instance);
  const double m = middle(config);
  Polygon polygon = star(random, 24, 0.3 * m, 0.9 * m, {m, m});
  for (Point& p : polygon) p = {std::round(p.x), std::round(p.y)};
  return one(polygon, config);
}

Scene grid_rectangle(const SlbConfig& config, std::uint64_t instance) {
  Random random(instance);
  const auto side = static_cast<std::int64_t>(config.side());
  const auto x0 = static_cast<double>(random.integer(0, side / 2)),
             y0 = static_cast<double>(random.integer(0, side / 2));
  const double x1 = x0 + static_cast<double>(random.integer(1, side / 2)),
               y1 = y0 + static_cast<double>(random.integer(1, side / 2));
  return one({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, config);
}

}  // namespace

std::uint64_t Random::bits() {
  state_ += 0x9E3779B97F4A7C15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}
double Random::unit() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}
double Random::between(double low, double high) {
  return low + (high - low) * unit();
}
std::int64_t Random::integer(std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(high - low + 1));
}

Polygon star(Random& random, int corners, double low, double high, Point centre) {
  Polygon polygon;
  const double start = random.between(0, kTurn);
  for (int i = 0; i < corners; ++i) {
    const double t = start + kTurn * (i + random.between(0, 0.8)) / corners, r = random.between(low, high);
    polygon.push_back({centre.x + r * std::cos(t), centre.y + r * std::sin(t)});
  }
  return polygon;
}

Loop quantise(const Polygon& polygon, const SlbConfig& config, std::uint32_t depth) {
  Loop loop;
  const auto scale = static_cast<double>(config.subpixels());
  for (const Point& p : polygon)
    loop.push_back({std::llround(p.x * scale), std::llround(p.y * scale), depth});
  return loop;
}

double perimeter(const Scene& scene, const SlbConfig& config) {
  double sum = 0;
  for (const Object& object : scene)
    for (const Loop& loop : object)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vertex &a = loop[i], &b = loop[(i + 1) % loop.size()];
        sum += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
      }
  return sum / static_cast<double>(config.subpixels());
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{
      {"random 24-gon", random_polygon},   {"smooth, edges 1.4 px", smooth_100},
      {"smooth, edges 0.5 px", smooth_05}, {"smooth, edges 0.14 px", smooth_014},
      {"gear, pitch 5 px", gear_5},        {"gear, pitch 3 px", gear_3},
      {"gear, pitch 2 px", gear_2},        {"strip 1 px", strip_1},
      {"strip 0.5 px", strip_05},          {"strip 0.1 px", strip_01},
      {"sharing an edge", sharing},        {"overlapping", overlapping},
      {"pixel corners", pixel_corners},    {"grid rectangle", grid_rectangle}};
  return all;
}

const Shape& shape(const std::string& name) {
  const auto found =
      std::find_if(shapes().begin(), shapes().end(), [&](const Shape& s) { return s.name == name; });
  if (found == shapes().end()) throw std::out_of_range("no shape is called " + name);
  return *found;
}

}  // namespace gnomon::golden::slb::testing
