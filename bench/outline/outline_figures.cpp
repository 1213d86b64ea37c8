// SPDX-License-Identifier: Apache-2.0
// What outlines of given models cost, how far they are from the exact contour, and what shadow the buffer
// makes of them:
//   outline_figures pixels|length PLANE_LOG2 FRAC_BITS MODEL.obj ...
// (edges fitted to pixels, or by their length alone).
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <unordered_map>

#include "bench/outline/buffer.hpp"
#include "host/outline/outline.hpp"
#include "host/scene/scene.hpp"
#include "tests/host/outline/winding.hpp"

namespace {

using namespace gnomon;

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

/// A view along `light` in which the box fills 15/16 of a plane of `side` pixels.
outline::LightFrame frame_for(const Box3& box, const Vec3& light, double side) {
  const Vec3 d = light.normalized();
  const Vec3 x = d.cross(Vec3(0, 1, 0)).normalized();
  const Vec3 y = x.cross(d);
  const double scale = side * 15 / 16 / box.size().length();
  const Vec3 c = box.center();
  outline::LightFrame f{x * scale, y * scale, d * (scale * 1000)};
  f.x1 = side / 2 - f.x.dot(c);
  f.y1 = side / 2 - f.y.dot(c);
  f.depth1 = 500000 - f.depth.dot(c);
  return f;
}

/// Edges binned by pixel, for distances.
class Edges {
 public:
  explicit Edges(const std::vector<outline::Loop>& loops) {
    for (const auto& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto& a = loop[i];
        const auto& b = loop[(i + 1) % loop.size()];
        for (int x = cell(std::min(a.x, b.x)); x <= cell(std::max(a.x, b.x)); ++x)
          for (int y = cell(std::min(a.y, b.y)); y <= cell(std::max(a.y, b.y)); ++y)
            bins_[key(x, y)].push_back({a, b});
      }
  }
  double distance(double x, double y) const {
    double best = 2;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const auto found = bins_.find(key(cell(x) + dx, cell(y) + dy));
        if (found == bins_.end()) continue;
        for (const auto& [a, b] : found->second) {
          const double ex = b.x - a.x;
          const double ey = b.y - a.y;
          const double s = std::clamp(((x - a.x) * ex + (y - a.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
          best = std::min(best, std::hypot(x - a.x - s * ex, y - a.y - s * ey));
        }
      }
    return best;
  }

 private:
  static int cell(double x) { return static_cast<int>(std::floor(x)); }
  static long key(int x, int y) { return static_cast<long>(x) * 100000 + y; }
  std::unordered_map<long, std::vector<std::pair<outline::Vertex, outline::Vertex>>> bins_;
};

struct Displacement {
  double mean = 0, largest = 0, length = 0;
};

Displacement displacement(const std::vector<outline::Loop>& loops, const Edges& exact) {
  constexpr int kSamples = 5;
  Displacement d;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& a = loop[i];
      const auto& b = loop[(i + 1) % loop.size()];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      d.length += length;
      for (int k = 0; k < kSamples; ++k) {
        const double s = (k + 0.5) / kSamples;
        const double off = exact.distance(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y));
        d.mean += length * off / kSamples;
        d.largest = std::max(d.largest, off);
      }
    }
  d.mean /= d.length;
  return d;
}

/// Mean displacement of the shadow's border in the buffer and in a shadow map 2^F times finer, of the same
/// points.
struct ShadowError {
  double buffer = 0, fine_map = 0;
};

ShadowError shadow_error(const std::vector<outline::Loop>& loops, const std::vector<outline::Loop>& exact,
                         int plane_log2, int frac_bits) {
  bench::Buffer buffer(plane_log2, frac_bits, loops);
  const outline::test::LoopSet truth(exact);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const double fine = std::ldexp(1.0, frac_bits);
  std::size_t wrong = 0;
  std::size_t wrong_fine = 0;
  for (const auto& loop : exact)
    for (const auto& v : loop) {
      const auto x = static_cast<std::int64_t>((v.x + (2 * unit(random) - 1) * 8 / fine) * 65536);
      const auto y = static_cast<std::int64_t>((v.y + (2 * unit(random) - 1) * 8 / fine) * 65536);
      const double px = (static_cast<double>(x) + 0.5) / 65536;
      const double py = (static_cast<double>(y) + 0.5) / 65536;
      const bool in = truth.winding(px, py) > 0;
      const double fx = (std::floor(px * fine) + 0.5) / fine;
      const double fy = (std::floor(py * fine) + 0.5) / fine;
      wrong += buffer.shadow(x, y) != in ? 1U : 0U;
      wrong_fine += (truth.winding(fx, fy) > 0) != in ? 1U : 0U;
    }
  const auto& counters = buffer.counters();
  fmt::print("  chains {} dropped {} reduced {}", counters.chains, counters.chains_dropped,
             counters.chains_reduced);
  return {static_cast<double>(wrong), static_cast<double>(wrong_fine)};
}

int run(const std::string& path, int plane_log2, int frac_bits, bool fit_pixels) {
  scene::SceneOptions options;
  options.ground = false;
  const auto loaded = scene::load_scene(path, options);
  if (!loaded) {
    fmt::print(stderr, "{}\n", loaded.error().message);
    return 2;
  }
  std::vector<surface::LimitSurface> surfaces;
  Box3 box;
  for (const scene::Object& object : loaded->objects) {
    const double start = 256 / object.bounds.size().length();  // about a grid of 256 voxels
    Mat4 grid;
    grid.setScale(Vec3(start));
    auto surface = surface::LimitSurface::build(object.mesh, object.to_world * grid);
    if (!surface) {
      fmt::print(stderr, "{}\n", surface.error().message);
      return 2;
    }
    box.extendBy(surface->bounds());
    surfaces.push_back(std::move(*surface));
  }
  const outline::LightFrame frame = frame_for(box, Vec3(-0.5, -1, -0.7), std::ldexp(1.0, plane_log2));
  outline::Options as_used;
  as_used.frac_bits = frac_bits;
  as_used.fit_pixels = fit_pixels;
  std::vector<double> times;
  std::vector<outline::ObjectOutline> result;
  for (int i = 0; i < 5; ++i) {
    const double before = user_seconds();
    auto outlines = outline::outlines(surfaces, frame, as_used);
    times.push_back(user_seconds() - before);
    if (!outlines) {
      fmt::print(stderr, "{}\n", outlines.error().message);
      return 2;
    }
    result = std::move(*outlines);
  }
  std::sort(times.begin(), times.end());
  outline::Options fine;
  fine.frac_bits = 16;
  fine.min_edge = 0.05;
  fine.fit_pixels = false;
  const auto exact = outline::outlines(surfaces, frame, fine);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& s = result[i].statistics;
    const Displacement d = displacement(result[i].loops, Edges((*exact)[i].loops));
    fmt::print(
        "{} faces {} on contour {} cells {} found {} border {} | loops {} vertices {} dropped {} | length "
        "{:.0f} px "
        "mean edge {:.2f} px | off: mean {:.3f} largest {:.2f} of 2^-F px | user {:.0f} ms\n",
        loaded->name, s.faces, s.contour_faces, s.cells, s.contour_vertices, s.border_vertices,
        result[i].loops.size(), s.vertices, s.dropped_loops, d.length,
        d.length / static_cast<double>(s.vertices), std::ldexp(d.mean, frac_bits),
        std::ldexp(d.largest, frac_bits), times[2] * 1000);
    const ShadowError e = shadow_error(result[i].loops, (*exact)[i].loops, plane_log2, frac_bits);
    fmt::print("  shadow: {:.3f} of a map 2^F finer\n", e.buffer / e.fine_map);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string edges = argc > 1 ? argv[1] : "";
  if (argc < 5 || (edges != "pixels" && edges != "length")) {
    fmt::print(stderr, "usage: outline_figures pixels|length PLANE_LOG2 FRAC_BITS MODEL.obj ...\n");
    return 2;
  }
  for (int i = 4; i < argc; ++i)
    if (const int status = run(argv[i], std::stoi(argv[2]), std::stoi(argv[3]), edges == "pixels");
        status != 0)
      return status;
  return 0;
}
