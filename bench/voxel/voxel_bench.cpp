// SPDX-License-Identifier: Apache-2.0
// Voxels per second of CPU time, on cages of our own and on those named on the command line
// (`voxel_bench [--benchmark_...] [MODEL.obj]...`). Run by hand; one core unless said otherwise.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "host/scene/scene.hpp"
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

/// A model as `gnomon voxelize` takes it, without a ground.
Scene load(const std::string& path, std::uint32_t res) {
  scene::SceneOptions options;
  options.ground = false;
  const auto loaded = scene::load_scene(path, options);
  if (!loaded) {
    std::cerr << loaded.error().message << '\n';
    std::exit(2);
  }
  Scene s;
  s.grid = *scene::fit_grid(*loaded, res, voxel::Adjacency::N26);
  for (const scene::Object& object : loaded->objects)
    s.surfaces.push_back(*surface::LimitSurface::build(object.mesh, scene::to_grid(object, s.grid)));
  return s;
}

void model(benchmark::State& state, const std::string& path) {
  const Scene s = load(path, static_cast<std::uint32_t>(state.range(0)));
  voxel::VoxelizerOptions options;
  options.threads = 1;
  std::size_t voxels = 0;
  while (state.KeepRunning())
    voxels += voxel::voxelize_coordinates(s.surfaces, s.grid, options)->voxels.size();
  state.SetItemsProcessed(static_cast<std::int64_t>(voxels));
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (int i = 1; i < argc; ++i) {
    const std::string path = argv[i];
    benchmark::RegisterBenchmark(path.c_str(), [path](benchmark::State& state) { model(state, path); })
        ->ArgName("res")
        ->ArgsProduct({{256, 512, 1024}})
        ->MeasureProcessCPUTime();
  }
  benchmark::RunSpecifiedBenchmarks();
}
