// SPDX-License-Identifier: Apache-2.0
// N = 6: the voxels that a block's leaves touch between their corners. Theory: docs/voxelization.md, "N = 6".
#include <algorithm>
#include <cmath>
#include <limits>

#include "host/surface/borders.hpp"
#include "host/voxel/block_worker.hpp"

namespace gnomon::voxel {

namespace {

// Triangles that leave the surface by more than this would touch voxels that the surface does not. In voxels,
// as all lengths here.
constexpr double kFlat = 0.004;

// Leaves no larger than this are good enough, however they are bent.
constexpr double kSmall = 0.25;

Vec3 position(const GridPoint& p) {
  return Vec3(p[0], p[1], p[2]) * 0x1p-16;
}

}  // namespace

// A point of the lattice, evaluated if it has not been.
Vec3 BlockWorker::position_at(int i, int j) {
  lattice_.at<true>(i, j);
  return position(lattice_.point(i, j));
}

// Which directions of a leaf must be split because the surface is too far from the leaf's triangles.
Split BlockWorker::straighten(const Box& b) {
  const double u = static_cast<double>(b.i1 - b.i0) / lattice_.width();
  const double v = static_cast<double>(b.j1 - b.j0) / lattice_.height();
  const auto bound = [&](double part_u, double part_v) {
    return bend_ ? bend_->sag(part_u, part_v) : std::numeric_limits<double>::infinity();
  };
  if (bound(u, v) <= kFlat) return {};
  const Vec3 p00 = position(lattice_.point(b.i0, b.j0));
  const Vec3 p10 = position(lattice_.point(b.i1, b.j0));
  const Vec3 p11 = position(lattice_.point(b.i1, b.j1));
  const Vec3 p01 = position(lattice_.point(b.i0, b.j1));
  const bool small = std::max((p11 - p00).length2(), (p01 - p10).length2()) <= kSmall * kSmall;
  if (small && bound(u, v) <= kSmall) return {};
  if (log_u(b) == rules_.smallest_log || log_v(b) == rules_.smallest_log) return {};
  if (b.i1 - b.i0 == 1 || b.j1 - b.j0 == 1) {  // its middle is not on the lattice: decided on a finer one
    postpone(b, {true, true});
    return {};
  }
  const Vec3 normal = (p11 - p00).cross(p01 - p10).normalized();  // zero if the corners are on a line
  const auto bent = [&](const Vec3& off) {
    return (normal.length2() == 0 ? off.length() : std::abs(off.dot(normal))) > kFlat;
  };
  const Split split{bent(off_u(b, b.j0)) || bent(off_u(b, b.j1)),
                    bent(off_v(b, b.i0)) || bent(off_v(b, b.i1))};
  if (!split.none()) return split;
  const Vec3 off = position_at((b.i0 + b.i1) / 2, (b.j0 + b.j1) / 2) - (p00 + p11) / 2;
  if ((small && off.length() <= kSmall) || !bent(off)) return {};
  return {true, true};
}

// How far the middle of a leaf's side along u lies from the middle between its ends.
Vec3 BlockWorker::off_u(const Box& b, int j) {
  if (bend_) return lattice_.off_u(b.i0, b.i1, j);
  return position_at((b.i0 + b.i1) / 2, j) - (position_at(b.i0, j) + position_at(b.i1, j)) / 2;
}

Vec3 BlockWorker::off_v(const Box& b, int i) {
  if (bend_) return lattice_.off_v(i, b.j0, b.j1);
  return position_at(i, (b.j0 + b.j1) / 2) - (position_at(i, b.j0) + position_at(i, b.j1)) / 2;
}

// A touched voxel takes the nearest thing to a representative: a corner of the leaf, moved into the voxel.
void BlockWorker::touch(const Triangle& triangle, int i, int j, BlockOutput& out) {
  for_each_touched(triangle, rules_.res, [&](VoxelKey key) {
    if (members_ != nullptr) {
      members_->insert(key);
    } else if (first_here(key)) {
      out.extra.push_back(moved_into(key, voxel_at_point(i, j)));
    }
  });
}

void BlockWorker::complete(const Box& b, BlockOutput& out) {
  const GridPoint p00 = lattice_.point(b.i0, b.j0);
  const GridPoint p11 = lattice_.point(b.i1, b.j1);
  touch({p00, lattice_.point(b.i1, b.j0), p11}, b.i0, b.j0, out);
  touch({p00, p11, lattice_.point(b.i0, b.j1)}, b.i0, b.j0, out);
  complete_side({b.i0, b.j0, b.i1, b.j0}, out);
  complete_side({b.i0, b.j1, b.i1, b.j1}, out);
  complete_side({b.i0, b.j0, b.i0, b.j1}, out);
  complete_side({b.i1, b.j0, b.i1, b.j1}, out);
}

// Points that finer neighbours have put on this side leave a gap between the side and their polygon.
void BlockWorker::complete_side(const Box& side, BlockOutput& out) {
  const bool along_u = side.j0 == side.j1;
  const int across = along_u ? side.j0 : side.i0;
  if (across == 0 || across == (along_u ? lattice_.height() : lattice_.width())) {
    record_side(side, out);
    return;
  }
  const GridPoint first = lattice_.point(side.i0, side.j0);
  GridPoint last = first;
  const int begin = along_u ? side.i0 : side.j0;
  const int end = along_u ? side.i1 : side.j1;
  for (int t = begin + 1; t <= end; ++t) {
    const int i = along_u ? t : across;
    const int j = along_u ? across : t;
    if (!lattice_.visited(i, j)) continue;
    if (last != first) touch({first, last, lattice_.point(i, j)}, side.i0, side.j0, out);
    last = lattice_.point(i, j);
  }
}

// Other blocks and faces may put points on it: kept until all are done.
void BlockWorker::record_side(const Box& side, BlockOutput& out) {
  const std::uint32_t u0 = lattice_.u_at(side.i0);
  const std::uint32_t u1 = lattice_.u_at(side.i1);
  const std::uint32_t v0 = lattice_.v_at(side.j0);
  const std::uint32_t v1 = lattice_.v_at(side.j1);
  const bool along_u = v0 == v1;
  const std::uint32_t across = along_u ? v0 : u0;
  BorderSide s{{block_.object, block_.face, (along_u ? 0U : 1U), across},
               along_u ? u0 : v0,
               along_u ? u1 : v1,
               lattice_.point(side.i0, side.j0),
               lattice_.point(side.i1, side.j1),
               voxel_at_point(side.i0, side.j0)};
  if (across == 0 || across == kParameterOne) {
    // In the curve's own parameter, from the middle, which is no corner, and a quarter.
    const auto on_curve = [&](double t) {
      const double a = parameter(across);
      return lattice_.surface().borders().spot(block_.face, along_u ? t : a, along_u ? a : t);
    };
    const double t0 = parameter(s.t0);
    const double t1 = parameter(s.t1);
    const surface::BorderSpot middle = on_curve((t0 + t1) / 2);
    const double half = (on_curve((t0 + 3 * t1) / 4).t - middle.t) * 2;
    s.line = {block_.object, middle.id, 2, 0};
    s.t0 = static_cast<std::uint32_t>((middle.t - half) * (2.0 * kParameterOne));
    s.t1 = static_cast<std::uint32_t>((middle.t + half) * (2.0 * kParameterOne));
    if (s.t0 > s.t1) {
      std::swap(s.t0, s.t1);
      std::swap(s.p0, s.p1);
    }
  }
  out.sides.push_back(s);
}

}  // namespace gnomon::voxel
