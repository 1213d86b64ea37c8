// SPDX-License-Identifier: Apache-2.0
// The tessellation is as close to the limit surface as it says, and no larger than allowed.
#include "host/metrics/tessellation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "host/metrics/ray_scene.hpp"
#include "tests/host/metrics/fixtures.hpp"

namespace gnomon::metrics {
namespace {

struct Deviation {
  double worst = 0;
  std::size_t measured = 0;
};

/// Along the normals of random surface points: how far off the triangles are.
Deviation deviation(const surface::LimitSurface& surface, const std::vector<ParamRect>& rects) {
  const Vec3 center = surface.bounds().center();
  const ParametricMesh mesh = triangulate(surface, rects, center);
  RayScene scene(center);
  scene.add(mesh.points, mesh.triangles);
  scene.commit();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uniform_int_distribution<std::uint32_t> face(0, surface.face_count() - 1);
  Deviation result;
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t f = face(random);
    const double u = unit(random);
    const double v = unit(random);
    const Vec3 n = surface.normal(f, u, v);
    const auto hit = scene.first_hit(surface.position(f, u, v) + n, -n);
    if (!hit) continue;
    result.worst = std::max(result.worst, std::abs(double{hit->distance} - 1));
    ++result.measured;
  }
  return result;
}

TEST(Tessellation, KeepsTheSagOnSmoothSurfaces) {
  for (const auto& mesh :
       {fixtures::box({10, 10, 10}, {54, 54, 54}, false), fixtures::torus({32, 32, 32}, 20, 8, 8, 6),
        fixtures::prism(5, {32, 32, 32}, 20, 30, false)}) {
    const auto surfaces = fixtures::surfaces({mesh});
    TessellationOptions options;
    options.sag = 1.0 / 128;
    const Tessellation cells = tessellate(surfaces, options);
    EXPECT_EQ(cells.sag, options.sag);
    const Deviation found = deviation(surfaces[0], cells.rects[0]);
    EXPECT_EQ(found.measured, 20000u);
    EXPECT_LE(found.worst, 1.25 * options.sag) << mesh.name;
    EXPECT_GT(found.worst, 0.1 * options.sag) << mesh.name << ": far finer than asked for";
  }
}

TEST(Tessellation, LeavesFlatSurfacesCoarse) {
  const auto surfaces = fixtures::surfaces({fixtures::rectangle(0, 0, 64, 32, 3)});
  TessellationOptions options;
  options.longest_side = 16.5;
  EXPECT_EQ(tessellate(surfaces, options).cells, 8u);
}

TEST(Tessellation, RelaxesTheSagToStayWithinItsSize) {
  const auto surfaces = fixtures::surfaces({fixtures::box({10, 10, 10}, {54, 54, 54}, false)});
  TessellationOptions options;
  options.max_cells = 2000;
  const Tessellation cells = tessellate(surfaces, options);
  EXPECT_LE(cells.cells, 2000u);
  EXPECT_GT(cells.sag, options.sag);
  EXPECT_EQ(cells.rects[0].size(), cells.cells);
}

}  // namespace
}  // namespace gnomon::metrics
