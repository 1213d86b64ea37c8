// SPDX-License-Identifier: Apache-2.0
// Voxels per second of CPU time, on cages of our own. Run by hand; one core unless said otherwise.
#include <benchmark/benchmark.h>

#include <vector>

#include "host/voxel/voxelizer.hpp"
#include "tests/host/surface/cages.hpp"

namespace {

using namespace gnomon;

scene::ControlMesh cage(std::int64_t which) {
  switch (which) {
    case 0:
      return test::torus(8, 6);
    case 1:
      return test::spindle(3);
    default:
      return test::spindle(9);
  }
}

struct Scene {
  std::vector<surface::LimitSurface> surfaces;
  voxel::Grid grid;
};

Scene make_scene(const benchmark::State& state) {
  Scene s;
  s.grid.res = static_cast<std::uint32_t>(state.range(1));
  s.grid.adjacency = static_cast<voxel::Adjacency>(state.range(2));
  const auto mesh = cage(state.range(0));
  s.surfaces.push_back(std::move(*surface::LimitSurface::build(mesh, test::fit_to_grid({mesh}, s.grid.res))));
  return s;
}

void coordinates(benchmark::State& state) {
  const Scene s = make_scene(state);
  voxel::VoxelizerOptions options;
  options.threads = static_cast<unsigned>(state.range(3));
  std::size_t voxels = 0;
  while (state.KeepRunning())
    voxels += voxel::voxelize_coordinates(s.surfaces, s.grid, options)->voxels.size();
  state.SetItemsProcessed(static_cast<std::int64_t>(voxels));
}

void representatives(benchmark::State& state) {
  const Scene s = make_scene(state);
  voxel::VoxelizerOptions options;
  options.threads = static_cast<unsigned>(state.range(3));
  std::size_t voxels = 0;
  while (state.KeepRunning()) voxels += voxel::voxelize(s.surfaces, s.grid, options)->voxels.size();
  state.SetItemsProcessed(static_cast<std::int64_t>(voxels));
}

void surfaces(benchmark::State& state) {
  while (state.KeepRunning()) benchmark::DoNotOptimize(make_scene(state).surfaces.size());
}

}  // namespace

BENCHMARK(coordinates)
    ->ArgNames({"cage", "res", "n", "threads"})
    ->ArgsProduct({{0, 1, 2}, {256, 512, 1024}, {26}, {1}})
    ->Args({0, 512, 18, 1})
    ->Args({0, 512, 6, 1})
    ->Args({0, 512, 26, 2})
    ->MeasureProcessCPUTime();
BENCHMARK(representatives)
    ->ArgNames({"cage", "res", "n", "threads"})
    ->ArgsProduct({{0, 1, 2}, {512}, {26}, {1}})
    ->MeasureProcessCPUTime();
BENCHMARK(surfaces)
    ->ArgNames({"cage", "res", "n"})
    ->ArgsProduct({{0, 1, 2}, {512}, {26}})
    ->MeasureProcessCPUTime();

BENCHMARK_MAIN();
