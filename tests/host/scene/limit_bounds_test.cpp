// SPDX-License-Identifier: Apache-2.0
// How large limit surfaces are.
#include "host/scene/limit_bounds.hpp"

#include <gtest/gtest.h>

#include "host/scene/obj_reader.hpp"
#include "host/surface/limit_surface.hpp"
#include "tests/host/scene/files.hpp"

namespace gnomon::scene {
namespace {

ControlMesh read(std::string_view text) {
  const test::TempDir directory;
  return read_obj(directory.write("model.obj", text)).value().meshes.at(0);
}

TEST(LimitBounds, OfASmoothCubeIsTheLimitOfItsFaceCentres) {
  // A cube of side 2: the centre of a face goes to (36 f + 6 sum of edge + sum of corner)/64-like averages;
  // by symmetry the extreme is at the face's centre, 5/6 of... found by refining three times by hand:
  // 0.83333.
  const Box3 box = limit_bounds(read(test::cube_text()), Mat4()).value();
  const surface::LimitSurface surface = surface::LimitSurface::build(read(test::cube_text()), Mat4()).value();
  const double centre = surface.position(0, 0.5, 0.5).z;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.max[axis], centre, 1e-9);
    EXPECT_NEAR(box.min[axis], -centre, 1e-9);
  }
  EXPECT_LT(centre, 0.9);
}

TEST(LimitBounds, ReachNoFartherThanControlPointsAndAsFarAsAnySample) {
  const ControlMesh mesh = read(
      "v 0 0 0\nv 3 0.2 0\nv 2.5 2 0.4\nv 0 1 0\nv 0 0 2\nv 3 0.5 2\nv 2.2 2.6 1.5\nv 0.3 1 2.7\n"
      "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nt crease 2/1/0 6 7 1.7\n");
  const Box3 box = limit_bounds(mesh, Mat4()).value();
  const Box3 hull = hull_bounds(mesh, Mat4());
  const surface::LimitSurface surface = surface::LimitSurface::build(mesh, Mat4()).value();
  std::size_t samples = 0;
  for (std::uint32_t face = 0; face < surface.face_count(); ++face) {
    for (int i = 0; i <= 97; ++i) {
      for (int j = 0; j <= 97; ++j, ++samples) {
        const Vec3 p = surface.position(face, i / 97.0, j / 97.0);
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_GE(p[axis], box.min[axis] - 1e-9);
          ASSERT_LE(p[axis], box.max[axis] + 1e-9);
        }
      }
    }
  }
  EXPECT_EQ(samples, 6U * 98 * 98);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(box.min[axis], hull.min[axis]);
    EXPECT_LE(box.max[axis], hull.max[axis]);
  }
}

TEST(LimitBounds, WorkAtEveryScale) {
  const ControlMesh mesh = read(test::cube_text());
  const double reach = limit_bounds(mesh, Mat4()).value().max.x;
  for (const double scale : {1e-30, 1e-6, 1e6, 1e30}) {
    Mat4 to_world;
    to_world.setScale(Vec3(scale));
    EXPECT_NEAR(limit_bounds(mesh, to_world).value().max.y / scale, reach, 1e-9) << scale;
  }
}

TEST(LimitBounds, FollowTheTransform) {
  Mat4 turn, move;
  turn.setEulerAngles(Vec3(0, 0.7853981633974483, 0));
  move.setTranslation(Vec3(10, 20, 30));
  const Box3 box = limit_bounds(read(test::cube_text()), turn * move).value();
  const Box3 straight = limit_bounds(read(test::cube_text()), Mat4()).value();
  EXPECT_NEAR(box.center().x, 10, 1e-9);
  EXPECT_NEAR(box.size().y, straight.size().y, 1e-9);
  EXPECT_GT(box.size().x, straight.size().x);
}

}  // namespace
}  // namespace gnomon::scene
