// SPDX-License-Identifier: Apache-2.0
// voxel_criteria MODEL.obj RES ADJACENCY: voxelizes a model and prints how good the voxels are. For runs by
// hand.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "criteria.hpp"
#include "host/scene/obj_reader.hpp"
#include "host/voxel/voxelizer.hpp"

namespace {

using namespace gnomon;

Mat4 fit(const std::vector<scene::ControlMesh>& meshes, double res) {
  Box3 box;
  for (const auto& m : meshes) {
    for (const Vec3& p : m.positions) box.extendBy(p);
  }
  const double scale = (res - 4) / std::max({box.size().x, box.size().y, box.size().z});
  Mat4 s;
  s.setScale(Vec3(scale));
  Mat4 t;
  t.setTranslation(Vec3(res / 2) - box.center() * scale);
  return s * t;
}

int report(const std::string& path, std::uint32_t res, int adjacency) {
  const auto model = scene::read_obj(path);
  if (!model) {
    fmt::print(stderr, "{}\n", model.error().message);
    return 2;
  }
  std::vector<surface::LimitSurface> surfaces;
  for (const auto& mesh : model->meshes) {
    auto s = surface::LimitSurface::build(mesh, fit(model->meshes, res));
    if (!s) {
      fmt::print(stderr, "{}\n", s.error().message);
      return 2;
    }
    surfaces.push_back(std::move(*s));
  }
  voxel::Grid grid;
  grid.res = res;
  grid.adjacency = static_cast<voxel::Adjacency>(adjacency);
  const auto set = voxel::voxelize(surfaces, grid);
  if (!set) {
    fmt::print(stderr, "{}\n", set.error().message);
    return 2;
  }
  const auto separation = test::separation(*set);
  const auto coverage = test::coverage(surfaces, *set, 0.15);
  const auto voxels = static_cast<double>(set->voxels.size());
  fmt::print(
      "voxels {}\ninside {}\nbays {}\nleaks {}\nsamples {}\nuncovered {}\nown_voxel {:.4f}\nfarthest_centre "
      "{:.4f}\n"
      "duplicates {}\nsurplus {:.4f}\nevaluations_per_voxel {:.4f}\nsubpatches_per_voxel {:.4f}\nfloor_hits "
      "{}\n"
      "zero_normals {}\nseconds {:.4f}\n",
      set->voxels.size(), separation.inside, separation.bays, separation.leaks, coverage.samples,
      coverage.uncovered, coverage.own_voxel, coverage.farthest_centre, test::duplicates(*set),
      test::surplus(*set), static_cast<double>(set->statistics.evaluations) / voxels,
      static_cast<double>(set->statistics.subpatches) / voxels, set->statistics.floor_hits,
      set->statistics.zero_normals, set->statistics.seconds);
  return separation.leaks == 0 && coverage.uncovered == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: voxel_criteria MODEL.obj RES 6|18|26\n");
    return 2;
  }
  const int adjacency = static_cast<int>(std::strtol(argv[3], nullptr, 10));
  if (adjacency != 6 && adjacency != 18 && adjacency != 26) {
    fmt::print(stderr, "adjacency must be 6, 18 or 26\n");
    return 2;
  }
  return report(argv[1], static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)), adjacency);
}
