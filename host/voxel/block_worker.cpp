// SPDX-License-Identifier: Apache-2.0
// The recursion over a block's lattice; voxels and representatives are read off the lattice afterwards.
#include "host/voxel/block_worker.hpp"

#include <algorithm>
#include <utility>

namespace gnomon::voxel {
namespace {

// Cells that need more than the lattice has (N = 18 near voxel corners; where the bound on the derivatives
// was an estimate) get small lattices of their own, log2 of its cells a side.
constexpr int kSmallLattice = 2;

// N = 6 needs all points of a block together: there the whole lattice is made finer, up to this size.
constexpr int kLargestGrowth = 20;

}  // namespace

void BlockWorker::run(const Block& block, BlockOutput& out) {
  run_cell(block, out);
  out.area += block.area();
}

void BlockWorker::run_cell(Block block, BlockOutput& out) {
  if (out.outside) return;
  block_ = block;
  lattice_.start(block);
  if (exact_) bend_ = lattice_.bend();
  recurse_block();
  if (leaves_grid(out)) return;
  while (grow_u_ || grow_v_) {
    const int more_u = grow_u_ ? 1 : 0;
    const int more_v = grow_v_ ? 1 : 0;
    block_.cells_u += more_u;
    block_.cells_v += more_v;
    if (block_.cells_u + block_.cells_v > kLargestGrowth) return run_children(block_, out);
    lattice_.refine(more_u, more_v);
    recurse_block();
    if (leaves_grid(out)) return;
  }
  collect(out);
  const auto coarse = std::exchange(coarse_, {});
  for (const Cell& c : coarse) {
    run_cell({block.object, block.face, c, std::min(kSmallLattice, c.log_u - rules_.smallest_log),
              std::min(kSmallLattice, c.log_v - rules_.smallest_log)},
             out);
  }
}

// Beyond the grid all points look alike: nothing that follows would make sense.
bool BlockWorker::leaves_grid(BlockOutput& out) const {
  if (!lattice_.leaves_grid()) return false;
  lattice_.for_each_visited([&](int i, int j) {
    GridGuard guard(rules_.res);
    guard.add(lattice_.key(i, j));
    if (!guard.crossed() || out.outside) return;
    out.outside = {block_.object, block_.face, parameter(lattice_.u_at(i)), parameter(lattice_.v_at(j))};
  });
  return true;
}

// N = 6: one step of the recursion by hand, where the block's lattice would be too large.
void BlockWorker::run_children(Block block, BlockOutput& out) {
  lattice_.for_each_visited([&](int, int) { ++out.statistics.evaluations; });
  const int w = lattice_.width();
  const int h = lattice_.height();
  const Corners corners{lattice_.key(0, 0), lattice_.key(w, 0), lattice_.key(w, h), lattice_.key(0, h)};
  const Split possible{block.cell.log_u > rules_.smallest_log, block.cell.log_v > rules_.smallest_log};
  const Split wanted = rules_.split(corners, block.cell.log_u >= block.cell.log_v);
  Split split{wanted.u && possible.u, wanted.v && possible.v};
  if (split.none()) split = possible;  // it is bent, and larger than the smallest cell
  for (const Cell& c : block.cell.children(split)) {
    run_cell({block.object, block.face, c, std::clamp(block.cells_u - 1, 0, c.log_u - rules_.smallest_log),
              std::clamp(block.cells_v - 1, 0, c.log_v - rules_.smallest_log)},
             out);
  }
}

void BlockWorker::recurse_block() {
  leaves_.clear();
  coarse_.clear();
  grow_u_ = grow_v_ = false;
  leaf_count_ = floor_hits_ = zero_normals_ = 0;
  switch (rules_.adjacency) {
    case Adjacency::N18:
      recurse_all<Adjacency::N18>();
      break;
    case Adjacency::N6:
      recurse_all<Adjacency::N6>();
      break;
    case Adjacency::N26:
      recurse_all<Adjacency::N26>();
      break;
  }
}

template <Adjacency kAdjacency>
void BlockWorker::recurse_all() {
  constexpr bool kExact = kAdjacency == Adjacency::N6;
  const int w = lattice_.width();
  const int h = lattice_.height();
  visit<kAdjacency>({0, 0, w, h}, {lattice_.at<kExact>(0, 0), lattice_.at<kExact>(w, 0),
                                   lattice_.at<kExact>(w, h), lattice_.at<kExact>(0, h)});
}

// Most cells are leaves, so this part is inlined into the division that made them.
template <Adjacency kAdjacency>
[[gnu::always_inline]] inline void BlockWorker::visit(const Box& b, const Corners& c) {
  Split split = criterion<kAdjacency>(c, [&] { return log_u(b) >= log_v(b); });
  if constexpr (kAdjacency == Adjacency::N6) {
    if (split.none()) split = straighten(b);
  }
  if (split.none()) {
    keep_leaf(b);
  } else {
    divide<kAdjacency>(b, c, split);
  }
}

// The lattice is not fine enough for this cell.
void BlockWorker::postpone(const Box& b, Split split) {
  if (exact_) {
    grow_u_ = grow_u_ || (split.u && b.i1 - b.i0 == 1);
    grow_v_ = grow_v_ || (split.v && b.j1 - b.j0 == 1);
    return;
  }
  for (const int j : {b.j0, b.j1}) {
    for (const int i : {b.i0, b.i1}) lattice_.remember(i, j);
  }
  coarse_.push_back({lattice_.u_at(b.i0), lattice_.v_at(b.j0), log_u(b), log_v(b)});
}

template <Adjacency kAdjacency>
void BlockWorker::divide(const Box& b, const Corners& c, Split split) {
  split.u = split.u && log_u(b) > rules_.smallest_log;
  split.v = split.v && log_v(b) > rules_.smallest_log;
  if (split.none()) {
    ++floor_hits_;
    return keep_leaf(b);
  }
  if ((split.u && b.i1 - b.i0 == 1) || (split.v && b.j1 - b.j0 == 1)) return postpone(b, split);
  constexpr bool kExact = kAdjacency == Adjacency::N6;
  const int im = (b.i0 + b.i1) >> 1;
  const int jm = (b.j0 + b.j1) >> 1;
  if (split.u && split.v) {
    const VoxelKey south = lattice_.at<kExact>(im, b.j0);
    const VoxelKey west = lattice_.at<kExact>(b.i0, jm);
    const VoxelKey centre = lattice_.at<kExact>(im, jm);
    const VoxelKey east = lattice_.at<kExact>(b.i1, jm);
    const VoxelKey north = lattice_.at<kExact>(im, b.j1);
    visit<kAdjacency>({b.i0, b.j0, im, jm}, {c[0], south, centre, west});
    visit<kAdjacency>({im, b.j0, b.i1, jm}, {south, c[1], east, centre});
    visit<kAdjacency>({b.i0, jm, im, b.j1}, {west, centre, north, c[3]});
    visit<kAdjacency>({im, jm, b.i1, b.j1}, {centre, east, c[2], north});
  } else if (split.u) {
    const VoxelKey south = lattice_.at<kExact>(im, b.j0);
    const VoxelKey north = lattice_.at<kExact>(im, b.j1);
    visit<kAdjacency>({b.i0, b.j0, im, b.j1}, {c[0], south, north, c[3]});
    visit<kAdjacency>({im, b.j0, b.i1, b.j1}, {south, c[1], c[2], north});
  } else {
    const VoxelKey west = lattice_.at<kExact>(b.i0, jm);
    const VoxelKey east = lattice_.at<kExact>(b.i1, jm);
    visit<kAdjacency>({b.i0, b.j0, b.i1, jm}, {c[0], c[1], east, west});
    visit<kAdjacency>({b.i0, jm, b.i1, b.j1}, {west, east, c[2], c[3]});
  }
}

// Most repetitions of a voxel are near each other; what slips through is found when blocks are merged.
bool BlockWorker::first_here(VoxelKey key) {
  const std::size_t slot = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15U >> 40) & (recent_.size() - 1);
  if (recent_[slot] == key) return false;
  recent_[slot] = key;
  return true;
}

void BlockWorker::collect(BlockOutput& out) {
  std::uint64_t points = 0;
  if (members_ != nullptr) {
    lattice_.for_each_visited([&](int i, int j) {
      ++points;
      members_->insert(lattice_.key(i, j));
    });
  } else {
    recent_.assign(std::clamp<std::size_t>(std::bit_ceil(block_.points() / 2), 16, 4096), ~VoxelKey{0});
    lattice_.for_each_visited([&](int i, int j) {
      ++points;
      if (first_here(lattice_.key(i, j))) out.voxels.push_back(voxel_at_point(i, j));
    });
  }
  out.statistics.evaluations += points - lattice_.remembered();
  out.statistics.subpatches += leaf_count_;
  out.statistics.floor_hits += floor_hits_;
  out.statistics.zero_normals += zero_normals_;
  for (const Box& b : leaves_) {
    if (leaves_wanted_) record_leaf(b, out);
    if (exact_) complete(b, out);
  }
}

Voxel BlockWorker::voxel_at_point(int i, int j) {
  return members_ == nullptr ? lattice_.representative(i, j, zero_normals_) : bare_voxel(lattice_.key(i, j));
}

void BlockWorker::record_leaf(const Box& b, BlockOutput& out) const {
  const auto u = [&](int i) { return static_cast<float>(parameter(lattice_.u_at(i))); };
  const auto v = [&](int j) { return static_cast<float>(parameter(lattice_.v_at(j))); };
  out.leaves.push_back({block_.object,
                        block_.face,
                        u(b.i0),
                        v(b.j0),
                        u(b.i1),
                        v(b.j1),
                        {lattice_.key(b.i0, b.j0), lattice_.key(b.i1, b.j0), lattice_.key(b.i1, b.j1),
                         lattice_.key(b.i0, b.j1)}});
}

}  // namespace gnomon::voxel
