// SPDX-License-Identifier: Apache-2.0
// The recursion over a block's lattice; voxels and representatives are read off the lattice afterwards.
#include "host/voxel/block_worker.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace gnomon::voxel {
namespace {

// Cells that need more than the lattice has (N = 18 near voxel corners; where the bound on the derivatives
// was an estimate) get small lattices of their own, log2 of its cells a side.
constexpr int kSmallLattice = 2;

// N = 6 needs all points of a block together: there the whole lattice is made finer, up to this size.
constexpr int kLargestGrowth = 18;

inline std::array<std::uint32_t, 4> snap_lanes(const surface::Lane4& p, double res) {
  std::array<std::uint32_t, 4> out;
  for (std::size_t k = 0; k < 4; ++k) out[k] = snap(p.x[k], res);
  return out;
}

inline VoxelKey voxel_of(const std::array<std::uint32_t, 4>& fixed) {
  return pack(fixed[0] >> kFractionBits, fixed[1] >> kFractionBits, fixed[2] >> kFractionBits);
}

surface::Lane4 lanes(const Vec3& p) {
  return {{p.x, p.y, p.z, 0}};
}
Vec3 vec(const surface::Lane4& p) {
  return {p.x[0], p.x[1], p.x[2]};
}

}  // namespace

void BlockWorker::run(const Block& block, BlockOutput& out) {
  run_cell(block, out);
  out.area += block.area();
}

void BlockWorker::run_cell(Block block, BlockOutput& out) {
  run_lattice(block);
  while (grow_u_ || grow_v_) {
    if (block.cells_u + block.cells_v >= kLargestGrowth) return run_children(block, out);
    block.cells_u += grow_u_ ? 1 : 0;
    block.cells_v += grow_v_ ? 1 : 0;
    run_lattice(block);
  }
  collect(out);
  const auto coarse = std::exchange(coarse_, {});
  for (const Cell& c : coarse) {
    run_cell({block.object, block.face, c, std::min(kSmallLattice, c.log_u - rules_.smallest_log),
              std::min(kSmallLattice, c.log_v - rules_.smallest_log)},
             out);
  }
}

// One step of the recursion by hand.
void BlockWorker::run_children(const Block& block, BlockOutput& out) {
  const Corners corners{keys_[lattice(0, 0)], keys_[lattice(width_, 0)], keys_[lattice(width_, height_)],
                        keys_[lattice(0, height_)]};
  for (const Cell& c : block.cell.children(rules_.split(corners, block.cell.log_u >= block.cell.log_v))) {
    run_cell({block.object, block.face, c, std::min(block.cells_u, c.log_u - rules_.smallest_log) - 1,
              std::min(block.cells_v, c.log_v - rules_.smallest_log) - 1},
             out);
  }
}

void BlockWorker::run_lattice(const Block& block) {
  start(block);
  switch (rules_.adjacency) {
    case Adjacency::N6:
      recurse_all<Adjacency::N6>();
      break;
    case Adjacency::N18:
      recurse_all<Adjacency::N18>();
      break;
    case Adjacency::N26:
      recurse_all<Adjacency::N26>();
      break;
  }
}

void BlockWorker::start(const Block& block) {
  block_ = block;
  surface_ = &surfaces_[block.object];
  width_ = 1 << block.cells_u;
  height_ = 1 << block.cells_v;
  stride_ = static_cast<std::size_t>(width_) + 1;
  words_ = static_cast<std::size_t>(width_) / 64 + 1;
  const auto rows = static_cast<std::size_t>(height_) + 1;
  if (keys_.size() < stride_ * rows) keys_.resize(stride_ * rows);
  visited_.assign(words_ * rows, 0);
  row_ready_.assign(rows, 0);
  slope_ready_.assign(rows, 0);
  if (rows_.size() < rows) {
    rows_.resize(rows);
    slopes_.resize(rows);
  }
  if (rules_.adjacency == Adjacency::N6 && points_.size() < stride_ * rows) points_.resize(stride_ * rows);
  leaves_.clear();
  coarse_.clear();
  grow_u_ = grow_v_ = false;
  evaluations_ = leaf_count_ = floor_hits_ = zero_normals_ = 0;

  const Cell& c = block.cell;
  const double u0 = parameter(c.u0);
  const double v0 = parameter(c.v0);
  const auto region = surface_->pieces(block.face).region(u0, v0, parameter(c.u1()), parameter(c.v1()));
  patch_ = region.whole ? region.patch : nullptr;
  scale_ = 1 / region.size;
  u_origin_ = (u0 - region.u0) * scale_;
  v_origin_ = (v0 - region.v0) * scale_;
  u_step_ = parameter(1U << c.log_u) * scale_ / width_;
  v_step_ = parameter(1U << c.log_v) * scale_ / height_;
  // Sides of the face belong to their owners, upper sides of a piece to the next piece.
  own_u0_ = c.u0 == 0 ? 1 : 0;
  own_v0_ = c.v0 == 0 ? 1 : 0;
  own_u1_ = parameter(c.u1()) == region.u0 + region.size ? width_ - 1 : width_;
  own_v1_ = parameter(c.v1()) == region.v0 + region.size ? height_ - 1 : height_;
}

const BlockWorker::Row& BlockWorker::row(int j) {
  const auto r = static_cast<std::size_t>(j);
  if (row_ready_[r] == 0) {
    row_ready_[r] = 1;
    rows_[r] = patch_->row(v_origin_ + v_step_ * j);
  }
  return rows_[r];
}

template <Adjacency kAdjacency>
inline VoxelKey BlockWorker::keep(std::size_t index, const std::array<std::uint32_t, 4>& fixed) {
  if constexpr (kAdjacency == Adjacency::N6) points_[index] = {fixed[0], fixed[1], fixed[2]};
  return keys_[index] = voxel_of(fixed);
}

template <Adjacency kAdjacency>
[[gnu::noinline]] VoxelKey BlockWorker::foreign_voxel(int i, int j) {
  const std::uint32_t u = u_at(i);
  const std::uint32_t v = v_at(j);
  const bool on_border = u == 0 || v == 0 || u == kParameterOne || v == kParameterOne;
  if (on_border && kAdjacency != Adjacency::N6) {
    const auto answer = borders_[block_.object].voxel(block_.face, parameter(u), parameter(v), rules_.res);
    evaluations_ += answer.fresh ? 1 : 0;
    return keys_[lattice(i, j)] = answer.key;
  }
  ++evaluations_;
  return keep<kAdjacency>(
      lattice(i, j),
      snap_lanes(lanes(surface_->position(block_.face, parameter(u), parameter(v))), rules_.res));
}

template <Adjacency kAdjacency>
inline VoxelKey BlockWorker::at(int i, int j) {
  const std::size_t index = lattice(i, j);
  std::uint64_t& word = visited_[static_cast<std::size_t>(j) * words_ + static_cast<std::size_t>(i >> 6)];
  const std::uint64_t bit = std::uint64_t{1} << (i & 63);
  if ((word & bit) != 0) return keys_[index];
  word |= bit;
  if (!own(i, j)) return foreign_voxel<kAdjacency>(i, j);
  ++evaluations_;
  return keep<kAdjacency>(index, snap_lanes(surface::cubic(row(j), u_origin_ + u_step_ * i), rules_.res));
}

template <Adjacency kAdjacency>
void BlockWorker::recurse_all() {
  recurse<kAdjacency>({0, 0, width_, height_}, {at<kAdjacency>(0, 0), at<kAdjacency>(width_, 0),
                                                at<kAdjacency>(width_, height_), at<kAdjacency>(0, height_)});
}

template <Adjacency kAdjacency>
void BlockWorker::recurse(Box b, const Corners& c) {
  const int log_u = block_.cell.log_u - block_.cells_u + std::countr_zero(static_cast<unsigned>(b.i1 - b.i0));
  const int log_v = block_.cell.log_v - block_.cells_v + std::countr_zero(static_cast<unsigned>(b.j1 - b.j0));
  Split split = criterion<kAdjacency>(c, log_u >= log_v);
  if (split.none()) return keep_leaf(b);
  split.u = split.u && log_u > rules_.smallest_log;
  split.v = split.v && log_v > rules_.smallest_log;
  if (split.none()) {
    ++floor_hits_;
    return keep_leaf(b);
  }
  const bool coarse_u = split.u && b.i1 - b.i0 == 1;
  const bool coarse_v = split.v && b.j1 - b.j0 == 1;
  if (coarse_u || coarse_v) {
    if constexpr (kAdjacency == Adjacency::N6) {
      grow_u_ = grow_u_ || coarse_u;
      grow_v_ = grow_v_ || coarse_v;
    } else {
      coarse_.push_back({u_at(b.i0), v_at(b.j0), log_u, log_v});
    }
    return;
  }
  const int im = (b.i0 + b.i1) / 2;
  const int jm = (b.j0 + b.j1) / 2;
  if (split.u && split.v) {
    const VoxelKey south = at<kAdjacency>(im, b.j0);
    const VoxelKey west = at<kAdjacency>(b.i0, jm);
    const VoxelKey centre = at<kAdjacency>(im, jm);
    const VoxelKey east = at<kAdjacency>(b.i1, jm);
    const VoxelKey north = at<kAdjacency>(im, b.j1);
    recurse<kAdjacency>({b.i0, b.j0, im, jm}, {c[0], south, centre, west});
    recurse<kAdjacency>({im, b.j0, b.i1, jm}, {south, c[1], east, centre});
    recurse<kAdjacency>({b.i0, jm, im, b.j1}, {west, centre, north, c[3]});
    recurse<kAdjacency>({im, jm, b.i1, b.j1}, {centre, east, c[2], north});
  } else if (split.u) {
    const VoxelKey south = at<kAdjacency>(im, b.j0);
    const VoxelKey north = at<kAdjacency>(im, b.j1);
    recurse<kAdjacency>({b.i0, b.j0, im, b.j1}, {c[0], south, north, c[3]});
    recurse<kAdjacency>({im, b.j0, b.i1, b.j1}, {south, c[1], c[2], north});
  } else {
    const VoxelKey west = at<kAdjacency>(b.i0, jm);
    const VoxelKey east = at<kAdjacency>(b.i1, jm);
    recurse<kAdjacency>({b.i0, b.j0, b.i1, jm}, {c[0], c[1], east, west});
    recurse<kAdjacency>({b.i0, jm, b.i1, b.j1}, {west, east, c[2], c[3]});
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
  out.statistics.evaluations += evaluations_;
  out.statistics.subpatches += leaf_count_;
  out.statistics.floor_hits += floor_hits_;
  recent_.assign(std::clamp<std::size_t>(std::bit_ceil(block_.points() / 2), 16, 4096), ~VoxelKey{0});
  for (int j = 0; j <= height_; ++j) {
    for (std::size_t w = 0; w < words_; ++w) {
      for (std::uint64_t bits = visited_[static_cast<std::size_t>(j) * words_ + w]; bits != 0;
           bits &= bits - 1) {
        const int i = static_cast<int>(w) * 64 + std::countr_zero(bits);
        const VoxelKey key = keys_[lattice(i, j)];
        if (!first_here(key)) continue;
        if (wanted_.representatives) {
          out.voxels.push_back(representative(i, j));
        } else {
          out.keys.push_back(key);
        }
      }
    }
  }
  out.statistics.zero_normals += zero_normals_;
  for (const Box& b : leaves_) {
    if (wanted_.leaves) record_leaf(b, out);
    if (rules_.adjacency == Adjacency::N6) complete(b, out);
  }
}

void BlockWorker::record_leaf(const Box& b, BlockOutput& out) const {
  const auto at_u = [&](int i) { return static_cast<float>(parameter(u_at(i))); };
  const auto at_v = [&](int j) { return static_cast<float>(parameter(v_at(j))); };
  out.leaves.push_back({block_.object,
                        block_.face,
                        at_u(b.i0),
                        at_v(b.j0),
                        at_u(b.i1),
                        at_v(b.j1),
                        {keys_[lattice(b.i0, b.j0)], keys_[lattice(b.i1, b.j0)], keys_[lattice(b.i1, b.j1)],
                         keys_[lattice(b.i0, b.j1)]}});
}

Vec3 BlockWorker::unit_normal(int i, int j) {
  if (patch_ != nullptr) {
    const auto r = static_cast<std::size_t>(j);
    if (slope_ready_[r] == 0) {
      slope_ready_[r] = 1;
      slopes_[r] = patch_->row_slope(v_origin_ + v_step_ * j);
    }
    const double u = u_origin_ + u_step_ * i;
    const Vec3 du = vec(surface::cubic_slope(row(j), u));
    const Vec3 dv = vec(surface::cubic(slopes_[r], u));
    const Vec3 n = du.cross(dv);
    constexpr double kSmallestSine2 = 1e-12;
    if (n.length2() > kSmallestSine2 * du.length2() * dv.length2()) return n / n.length();
  }
  const auto n = surface_->unit_normal(block_.face, parameter(u_at(i)), parameter(v_at(j)));
  zero_normals_ += n.nudged ? 1 : 0;
  return n.direction;
}

Voxel BlockWorker::representative(int i, int j) {
  Voxel v{};
  const VoxelKey key = keys_[lattice(i, j)];
  v.x = static_cast<std::uint16_t>(key_x(key));
  v.y = static_cast<std::uint16_t>(key_y(key));
  v.z = static_cast<std::uint16_t>(key_z(key));
  v.object = static_cast<std::uint16_t>(block_.object);
  v.face = block_.face;
  v.u = static_cast<float>(parameter(u_at(i)));
  v.v = static_cast<float>(parameter(v_at(j)));
  const auto fixed =
      snap_lanes(own(i, j) ? surface::cubic(row(j), u_origin_ + u_step_ * i)
                           : lanes(surface_->position(block_.face, parameter(u_at(i)), parameter(v_at(j)))),
                 rules_.res);
  const Vec3 n = unit_normal(i, j);
  for (int k = 0; k < 3; ++k) {
    v.point[k] = static_cast<float>(fixed[static_cast<std::size_t>(k)] & 0xffff) * 0x1p-16F;
    v.normal[k] = static_cast<float>(n[k]);
  }
  return v;
}

}  // namespace gnomon::voxel
