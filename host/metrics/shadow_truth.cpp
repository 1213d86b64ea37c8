// SPDX-License-Identifier: Apache-2.0
// Classifies samples and voxels, then asks where the answers change.
#include "host/metrics/shadow_truth.hpp"

#include <tbb/parallel_for.h>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "host/metrics/cell_answers.hpp"
#include "host/metrics/light_scale.hpp"
#include "host/metrics/sample_grid.hpp"
#include "host/metrics/shadow_border.hpp"
#include "host/metrics/steady_voxels.hpp"

namespace gnomon::metrics {
namespace {

class Sampler {
 public:
  Sampler(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
          const voxel::VoxelSet& voxels)
      : reference_(reference), scale_(reference.light()), surfaces_(surfaces), index_(voxels) {}

  VoxelIndex::Walk walk() const { return VoxelIndex::Walk(index_); }

  /// `walk` goes from sample to sample.
  SurfaceSample sample(const FaceGrid& grid, std::uint32_t i, std::uint32_t j, VoxelIndex::Walk& walk) const {
    const surface::LimitSurface& surface = surfaces_[grid.object];
    const auto [u, v] = sample_parameter(grid, i, j);
    const surface::SurfacePoint p = surface.evaluate(grid.face, u, v);
    const Vec3 across = p.du.cross(p.dv);
    const double area = scale_.area(across, double{1} * grid.nu * grid.nv, p.position);
    const SurfaceQuery query{p.position, surface.normal(grid.face, u, v), grid.object};
    SurfaceSample sample{};
    sample.x = static_cast<float>(p.position.x);
    sample.y = static_cast<float>(p.position.y);
    sample.z = static_cast<float>(p.position.z);
    sample.light_area = static_cast<float>(area);
    sample.facing = static_cast<float>(reference_.facing(query.point, query.normal, grid.object));
    sample.voxel = walk.answering(p.position);
    sample.object = static_cast<std::uint16_t>(grid.object);
    sample.exact = reference_.classify(query);
    return sample;
  }

 private:
  const ExactReference& reference_;
  LightScale scale_;
  std::span<const surface::LimitSurface> surfaces_;
  VoxelIndex index_;
};

std::vector<SurfaceSample> take_samples(const Sampler& sampler, const SampleGrids& grids,
                                        const TruthOptions& options) {
  std::vector<SurfaceSample> samples(grids.cells);
  const std::vector<GridRow> rows = grids.cell_rows();
  Progress progress(rows.size(), options.progress, options.cancelled);
  tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t r) {
    const FaceGrid& grid = grids.faces[rows[r].grid];
    VoxelIndex::Walk walk = sampler.walk();
    for (std::uint32_t i = 0; i < grid.nu; ++i)
      samples[grid.cell(i, rows[r].row)] = sampler.sample(grid, i, rows[r].row, walk);
    progress.step();
  });
  return samples;
}

/// Fine samples in the cells that the border crosses, cell by cell.
std::vector<SurfaceSample> take_border_samples(const Sampler& sampler, const SampleGrids& grids,
                                               std::span<const CellRef> cells) {
  constexpr std::size_t kEach = std::size_t{kBorderSplit} * kBorderSplit;
  std::vector<SurfaceSample> samples(cells.size() * kEach);
  tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t c) {
    FaceGrid fine = grids.faces[cells[c].grid];
    fine.nu *= kBorderSplit;
    fine.nv *= kBorderSplit;
    VoxelIndex::Walk walk = sampler.walk();
    for (std::uint32_t k = 0; k < kEach; ++k) {
      samples[c * kEach + k] = sampler.sample(fine, cells[c].i * kBorderSplit + k % kBorderSplit,
                                              cells[c].j * kBorderSplit + k / kBorderSplit, walk);
    }
  });
  return samples;
}

std::vector<Exact> voxel_answers(const ExactReference& reference,
                                 std::span<const surface::LimitSurface> surfaces,
                                 const voxel::VoxelSet& voxels) {
  std::vector<Exact> answers(voxels.voxels.size());
  // From the parameters, not from the stored point and normal: those are single precision.
  tbb::parallel_for(std::size_t{0}, answers.size(), [&](std::size_t i) {
    const voxel::Voxel& v = voxels.voxels[i];
    answers[i] = exact_at(reference, surfaces, v.object, v.face, double{v.u}, double{v.v});
  });
  return answers;
}

}  // namespace

ShadowTruth shadow_truth(const ExactReference& reference, std::span<const surface::LimitSurface> surfaces,
                         const voxel::VoxelSet& voxels, const TruthOptions& options) {
  if (!(options.spacing > 0)) throw std::invalid_argument("sample spacing must be positive");
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t rays_before = reference.rays();
  ShadowTruth truth;
  truth.sag = reference.sag();
  for (std::uint32_t object = 0; object < surfaces.size(); ++object)
    truth.receives.push_back(reference.receives(object) ? 1 : 0);
  const SampleGrids grids = sample_grids(surfaces, options.spacing, truth.receives);
  const Sampler sampler(reference, surfaces, voxels);
  truth.samples = take_samples(sampler, grids, options);
  truth.voxels = voxel_answers(reference, surfaces, voxels);
  std::vector<Exact> answers(truth.samples.size());
  for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = truth.samples[i].exact;
  ShadowBorder border = shadow_border(reference, surfaces, grids, answers, options.spacing);
  truth.unambiguous = unambiguous_voxels(voxels, truth.voxels, truth.receives, truth.samples, border.points);
  truth.steady = steady_voxels(reference, surfaces, voxels, truth.voxels, truth.unambiguous);
  truth.border = std::move(border.length);
  truth.on_border.resize(truth.samples.size());
  for (const CellRef& at : border.cells) truth.on_border[grids.faces[at.grid].cell(at.i, at.j)] = 1;
  truth.border_samples = take_border_samples(sampler, grids, border.cells);
  truth.rays = reference.rays() - rays_before;
  truth.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return truth;
}

}  // namespace gnomon::metrics
