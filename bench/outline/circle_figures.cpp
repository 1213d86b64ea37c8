// SPDX-License-Identifier: Apache-2.0
// How edges should be chosen: the displacement of the buffer's shadow from exact circles, over that of a
// shadow map 2^F times finer (0.244 * 2^-F pixels), for edges by their length alone and for edges fitted to
// pixels.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "bench/outline/buffer.hpp"
#include "host/outline/thinning.hpp"

namespace {

using namespace gnomon;

constexpr int kPlaneLog2 = 7;
constexpr int kCircles = 12;
constexpr int kQueries = 30000;
constexpr double kSpacing = 0.1;  // pixels between the points that are known

struct Circle {
  double x, y, radius, start;
};

outline::Loop dense(const Circle& c) {
  const int n = static_cast<int>(2 * std::numbers::pi * c.radius / kSpacing);
  outline::Loop loop;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * (i + c.start) / n;
    loop.push_back({c.x + c.radius * std::cos(a), c.y + c.radius * std::sin(a), 0});
  }
  return loop;
}

struct Figures {
  double ratio, edge;
};

Figures measure(int frac_bits, double radius, bool fit_pixels) {
  const double fine = std::ldexp(1.0, frac_bits);
  const outline::ThinningLimits limits{0.25 / fine, 1, 0.3, 4, fit_pixels};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const double reach = 4 / fine + 0.1 / radius;  // pixels to either side of the circle
  double wrong = 0;
  double edges = 0;
  for (int i = 0; i < kCircles; ++i) {
    const Circle c{64 + unit(random), 64 + unit(random), radius, unit(random)};
    const outline::Loop loop = outline::thinned(dense(c), limits);
    edges += static_cast<double>(loop.size());
    bench::Buffer buffer(kPlaneLog2, frac_bits, {loop});
    for (int k = 0; k < kQueries; ++k) {
      const double a = 2 * std::numbers::pi * unit(random);
      const double r = radius + (2 * unit(random) - 1) * reach;
      const auto x = static_cast<std::int64_t>((c.x + r * std::cos(a)) * 65536);
      const auto y = static_cast<std::int64_t>((c.y + r * std::sin(a)) * 65536);
      const bool inside = std::hypot((static_cast<double>(x) + 0.5) / 65536 - c.x,
                                     (static_cast<double>(y) + 0.5) / 65536 - c.y) < radius;
      wrong += buffer.shadow(x, y) != inside ? 1 : 0;
    }
  }
  const double mean = wrong / kCircles / kQueries * 2 * reach;
  return {mean * fine / 0.244, kCircles * 2 * std::numbers::pi * radius / edges};
}

}  // namespace

int main() {
  for (const int frac_bits : {3, 4, 7, 8})
    for (const double radius : {3.0, 5.0, 10.0, 22.0, 50.0}) {
      const Figures by_length = measure(frac_bits, radius, false);
      const Figures by_pixels = measure(frac_bits, radius, true);
      fmt::print(
          "F = {}, R = {:>2} px: by length {:.2f} (edges of {:.2f} px), fitted to pixels {:.2f} ({:.2f} "
          "px)\n",
          frac_bits, radius, by_length.ratio, by_length.edge, by_pixels.ratio, by_pixels.edge);
    }
  return 0;
}
