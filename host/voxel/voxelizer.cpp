// SPDX-License-Identifier: Apache-2.0
// Blocks through the workers, their voxels merged in the order of the blocks.
#include "host/voxel/voxelizer.hpp"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>

#include "host/voxel/block_worker.hpp"
#include "host/voxel/brick_set.hpp"

namespace gnomon::voxel {
namespace {

// Blocks are handed out in batches of about so many lattice points, so that small faces do not cost a task
// each.
constexpr std::size_t kBatchPoints = 32768;
constexpr std::uint32_t kLargestGrid = 65535;
constexpr std::size_t kMostObjects = 65536;

struct Batch {
  std::vector<Block> blocks;
  BlockOutput output;
};

std::optional<Error> check(std::span<const surface::LimitSurface> surfaces, const Grid& grid) {
  if (grid.res < 1 || grid.res > kLargestGrid) {
    return Error{fmt::format("res={} is out of range 1..{}", grid.res, kLargestGrid)};
  }
  if (surfaces.size() > kMostObjects) {
    return Error{
        fmt::format("{} objects are too many, at most {} can be voxelized", surfaces.size(), kMostObjects)};
  }
  return std::nullopt;
}

void add(VoxelStatistics& sum, const VoxelStatistics& s) {
  sum.evaluations += s.evaluations;
  sum.subpatches += s.subpatches;
  sum.floor_hits += s.floor_hits;
  sum.zero_normals += s.zero_normals;
}

// One run over all blocks. `merge` is called with every batch, one at a time and in order. Fails at the first
// point outside the grid.
class Run {
 public:
  Run(std::span<const surface::LimitSurface> surfaces, const Grid& grid, const VoxelizerOptions& options)
      : surfaces_(surfaces), rules_(RecursionRules::of(grid)), options_(options), source_(surfaces, rules_) {
    for (const auto& s : surfaces) {
      total_area_ += s.face_count();
      if (grid.adjacency != Adjacency::N6) borders_.emplace_back(s);
    }
  }

  template <class Merge>
  Result<VoxelStatistics> operator()(bool leaves, BrickSet* members, Merge merge) {
    VoxelStatistics statistics;
    std::optional<Outside> outside;
    std::atomic<bool> stop = false;
    tbb::enumerable_thread_specific<BrickSet> sets;
    const auto threads =
        options_.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(options_.threads);
    const tbb::global_control allow(
        tbb::global_control::max_allowed_parallelism,
        std::max<std::size_t>(options_.threads, tbb::global_control::active_value(
                                                    tbb::global_control::max_allowed_parallelism)));
    tbb::task_arena arena(threads);
    const std::size_t tokens = 4 * static_cast<std::size_t>(arena.max_concurrency());
    tbb::enumerable_thread_specific<BlockWorker> workers([&] {
      return BlockWorker(surfaces_, borders_, rules_, leaves, members == nullptr ? nullptr : &sets.local());
    });
    const auto produce = [&](tbb::flow_control& control) -> std::shared_ptr<Batch> {
      auto batch = stop ? nullptr : next_batch();
      if (!batch) control.stop();
      return batch;
    };
    const auto work = [&](std::shared_ptr<Batch> batch) {
      BlockWorker& worker = workers.local();
      worker.begin();
      for (const Block& b : batch->blocks) worker.run(b, batch->output);
      return batch;
    };
    const auto collect = [&](const std::shared_ptr<Batch>& batch) {
      if (!outside) outside = batch->output.outside;
      stop = outside.has_value();
      if (stop) return;
      merge(batch->output);
      add(statistics, batch->output.statistics);
      report(batch->output.area);
    };
    using Passed = std::shared_ptr<Batch>;
    arena.execute([&] {
      tbb::parallel_pipeline(tokens,
                             tbb::make_filter<void, Passed>(tbb::filter_mode::serial_in_order, produce) &
                                 tbb::make_filter<Passed, Passed>(tbb::filter_mode::parallel, work) &
                                 tbb::make_filter<Passed, void>(tbb::filter_mode::serial_in_order, collect));
    });
    if (outside) return tl::make_unexpected(error(*outside));
    for (BrickSet& set : sets) members->merge(std::move(set));
    statistics.evaluations += source_.evaluations();
    return statistics;
  }

 private:
  std::shared_ptr<Batch> next_batch() {
    auto batch = std::make_shared<Batch>();
    for (std::size_t points = 0; points < kBatchPoints;) {
      const auto block = source_.next();
      if (!block) break;
      batch->blocks.push_back(*block);
      points += block->points();
    }
    return batch->blocks.empty() ? nullptr : batch;
  }

  Error error(const Outside& o) const {
    const Vec3 p = surfaces_[o.object].position(o.face, o.u, o.v);
    return {fmt::format("object {} has a limit point at ({:.6g}, {:.6g}, {:.6g}), outside the grid 0..{}",
                        o.object, p.x, p.y, p.z, rules_.res)};
  }

  void report(double area) {
    done_area_ += area;
    if (options_.progress) options_.progress(done_area_ / total_area_);
  }

  std::span<const surface::LimitSurface> surfaces_;
  RecursionRules rules_;
  const VoxelizerOptions& options_;
  BlockSource source_;
  std::vector<BorderCache> borders_;
  double total_area_ = 0, done_area_ = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What N = 6 adds when all blocks are merged.
struct Extras {
  std::vector<Voxel> voxels;
  std::vector<BorderSide> sides;

  void gather(const BlockOutput& out) {
    voxels.insert(voxels.end(), out.extra.begin(), out.extra.end());
    sides.insert(sides.end(), out.sides.begin(), out.sides.end());
  }

  template <class Add>
  void release(std::uint32_t res, Add add_voxel) {
    for (const Voxel& v : voxels) add_voxel(v);
    for_each_gap(sides, [&](const BorderSide& side, const Triangle& gap) {
      for_each_touched(gap, res, [&](VoxelKey key) { add_voxel(moved_into(key, side.representative)); });
    });
  }
};

}  // namespace

Result<VoxelSet> voxelize(std::span<const surface::LimitSurface> surfaces, const Grid& grid,
                          const VoxelizerOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (const auto fault = check(surfaces, grid)) return tl::make_unexpected(*fault);
  VoxelSet set;
  set.grid = grid;
  BrickSet members(options.subpatches);
  Extras extras;
  const auto add_voxel = [&](const Voxel& v) {
    if (members.insert(key_of(v))) set.voxels.push_back(v);
  };
  Run run(surfaces, grid, options);
  const auto statistics = run(options.subpatches, nullptr, [&](const BlockOutput& out) {
    for (const Voxel& v : out.voxels) add_voxel(v);
    for (const LeafRecord& l : out.leaves) {
      set.subpatches.push_back({l.object,
                                l.face,
                                l.u0,
                                l.v0,
                                l.u1,
                                l.v1,
                                {members.index(l.corners[0]), members.index(l.corners[1]),
                                 members.index(l.corners[2]), members.index(l.corners[3])}});
    }
    extras.gather(out);
  });
  if (!statistics) return tl::make_unexpected(statistics.error());
  extras.release(grid.res, add_voxel);
  set.statistics = *statistics;
  set.statistics.seconds = seconds_since(start);
  return set;
}

Result<CoordinateSet> voxelize_coordinates(std::span<const surface::LimitSurface> surfaces, const Grid& grid,
                                           const VoxelizerOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (const auto fault = check(surfaces, grid)) return tl::make_unexpected(*fault);
  CoordinateSet set;
  set.grid = grid;
  BrickSet members;
  Extras extras;
  Run run(surfaces, grid, options);
  const auto statistics = run(false, &members, [&](const BlockOutput& out) { extras.gather(out); });
  if (!statistics) return tl::make_unexpected(statistics.error());
  set.statistics = *statistics;
  extras.release(grid.res, [&](const Voxel& v) { members.insert(key_of(v)); });
  set.voxels.reserve(members.size());
  members.for_each([&](VoxelKey k) {
    set.voxels.push_back({static_cast<std::uint16_t>(key_x(k)), static_cast<std::uint16_t>(key_y(k)),
                          static_cast<std::uint16_t>(key_z(k))});
  });
  set.statistics.seconds = seconds_since(start);
  return set;
}

}  // namespace gnomon::voxel
