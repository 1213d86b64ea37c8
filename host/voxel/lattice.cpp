// SPDX-License-Identifier: Apache-2.0
// Where a block's points come from: its polynomial, the owners of borders, or the surface point by point.
#include "host/voxel/lattice.hpp"

namespace gnomon::voxel {
namespace {

surface::Lane4 lanes(const Vec3& p) {
  return {{p.x, p.y, p.z, 0}};
}
Vec3 vec(const surface::Lane4& p) {
  return {p.x[0], p.x[1], p.x[2]};
}

}  // namespace

void Lattice::start(const Block& block) {
  if (block.face != block_.face || block.object != block_.object) memo_.start();
  block_ = block;
  surface_ = &surfaces_[block.object];
  pieces_ = &surface_->pieces(block.face);
  width_ = 1 << block.cells_u;
  height_ = 1 << block.cells_v;
  log_u_ = block.cell.log_u - block.cells_u;
  log_v_ = block.cell.log_v - block.cells_v;
  remembered_ = 0;
  guard_ = GridGuard(res_);

  const auto rows = static_cast<std::size_t>(height_) + 1;
  const std::size_t columns = static_cast<std::size_t>(width_) + 1;
  const std::size_t words = static_cast<std::size_t>(width_) / 64 + 1;
  if (keys_.size() < rows * columns) keys_.resize(rows * columns);
  if (keep_points_ && points_.size() < rows * columns) points_.resize(rows * columns);
  visited_.assign(rows * words, 0);
  if (lines_.size() < rows) {
    lines_.resize(rows);
    slopes_.resize(rows);
  }
  for (std::size_t j = 0; j < rows; ++j) {
    lines_[j].keys = keys_.data() + j * columns;
    lines_[j].visited = visited_.data() + j * words;
    lines_[j].ready = lines_[j].slope_ready = false;
  }
  map_to_piece();
  map_to_borders();
}

void Lattice::refine(int more_u, int more_v) {
  kept_.clear();
  for_each_visited([&](int i, int j) { kept_.push_back({i << more_u, j << more_v, point(i, j)}); });
  Block finer = block_;
  finer.cells_u += more_u;
  finer.cells_v += more_v;
  start(finer);
  for (const Kept& k : kept_) {
    line(k.j).visited[k.i >> 6] |= std::uint64_t{1} << (k.i & 63);
    keep<true>(k.i, k.j, {k.point[0], k.point[1], k.point[2], 0});
  }
}

std::optional<Bend> Lattice::bend() const {
  if (own_.patch == nullptr) return std::nullopt;
  return Bend::of(*own_.patch, own_.u(0), own_.u(width_), own_.v(0), own_.v(height_));
}

// For a cubic this is, exactly, an eighth of its second derivative in the middle.
Vec3 Lattice::off_u(int i0, int i1, int j) const {
  const double u = (own_.u(i0) + own_.u(i1)) / 2;
  const double length = own_.u(i1) - own_.u(i0);
  const auto& c = own_.patch->c;
  return (vec(surface::cubic(c[2], own_.v(j))) * 2 + vec(surface::cubic(c[3], own_.v(j))) * (6 * u)) *
         (length * length / -8);
}

Vec3 Lattice::off_v(int i, int j0, int j1) const {
  const double v = (own_.v(j0) + own_.v(j1)) / 2;
  const double length = own_.v(j1) - own_.v(j0);
  Row second;
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t x = 0; x < 4; ++x) {
      second[k].x[x] = 2 * own_.patch->c[k][2].x[x] + 6 * v * own_.patch->c[k][3].x[x];
    }
  }
  return vec(surface::cubic(second, own_.u(i))) * (length * length / -8);
}

Lattice::Chart Lattice::chart(std::uint32_t u0, std::uint32_t v0, std::uint32_t u1, std::uint32_t v1) const {
  const auto piece = pieces_->region(parameter(u0), parameter(v0), parameter(u1), parameter(v1));
  if (!piece.whole || piece.patch == nullptr) return {};
  return {piece.patch, (parameter(block_.cell.u0) - piece.u0) / piece.size,
          parameter(1U << log_u_) / piece.size, (parameter(block_.cell.v0) - piece.v0) / piece.size,
          parameter(1U << log_v_) / piece.size};
}

void Lattice::map_to_piece() {
  const Cell& c = block_.cell;
  own_ = chart(c.u0, c.v0, c.u1(), c.v1());
  right_ = above_ = {};
  above_row_.reset();
  own_columns_ = own_rows_ = 0;
  if (own_.patch == nullptr) return;
  // A block's border is shared with other blocks, and may belong to another piece or face.
  own_columns_ = static_cast<unsigned>(width_ - 1);
  own_rows_ = static_cast<unsigned>(height_ - 1);
  // The piece answers for its lower sides, the next one for its upper sides.
  const bool last_in_u = own_.u(width_) == 1;
  const bool last_in_v = own_.v(height_) == 1;
  last_own_u_ = last_in_u ? width_ - 1 : width_;
  last_own_v_ = last_in_v ? height_ - 1 : height_;
  if (last_in_u && c.u1() != kParameterOne) right_ = chart(c.u1(), c.v0, c.u1(), c.v1());
  if (last_in_v && c.v1() != kParameterOne) above_ = chart(c.u0, c.v1(), c.u1(), c.v1());
}

void Lattice::map_to_borders() {
  sides_ = {};
  if (keep_points_) return;
  const Cell& c = block_.cell;
  BorderCache& cache = borders_[block_.object];
  const double u0 = parameter(c.u0);
  const double v0 = parameter(c.v0);
  const double du = parameter(1U << log_u_);
  const double dv = parameter(1U << log_v_);
  if (c.v0 == 0) sides_[0] = cache.stretch(block_.face, u0, 0, du, 0);
  if (c.u1() == kParameterOne) sides_[1] = cache.stretch(block_.face, 1, v0, 0, dv);
  if (c.v1() == kParameterOne) sides_[2] = cache.stretch(block_.face, u0, 1, du, 0);
  if (c.u0 == 0) sides_[3] = cache.stretch(block_.face, 0, v0, 0, dv);
}

[[gnu::noinline]] const Lattice::Row& Lattice::row(int j) {
  Line& l = line(j);
  if (!l.ready) {
    l.ready = true;
    l.cubic = own_.patch->row(own_.v(j));
  }
  return l.cubic;
}

VoxelKey Lattice::foreign(int i, int j) {
  const std::uint32_t u = u_at(i);
  const std::uint32_t v = v_at(j);
  if (u == 0 || v == 0 || u == kParameterOne || v == kParameterOne) return border(i, j);
  if (keep_points_) return keep<true>(i, j, fixed(i, j));
  if (const auto known = memo_.find(u, v)) {
    ++remembered_;
    return line(j).keys[i] = *known;
  }
  const VoxelKey key = keep<false>(i, j, fixed(i, j));
  if (own_.patch != nullptr || i == 0 || j == 0 || i == width_ || j == height_) memo_.remember(u, v, key);
  return key;
}

VoxelKey Lattice::border(int i, int j) {
  if (keep_points_) return keep<true>(i, j, fixed(i, j));
  if (const BorderCache::Stretch* s = side(i, j)) {
    const int t = j == 0 || j == height_ ? i : j;
    if (const auto known = s->recall(t)) {
      ++remembered_;
      return line(j).keys[i] = *known;
    }
    if (s->own && own_.patch != nullptr) {
      const VoxelKey key = keep<false>(i, j, detail::snap_lanes(surface::cubic(row(j), own_.u(i)), res_));
      remembered_ += s->remember(t, key) ? 0U : 1U;
      return key;
    }
  }
  const auto answer =
      borders_[block_.object].voxel(block_.face, parameter(u_at(i)), parameter(v_at(j)), res_);
  remembered_ += answer.fresh ? 0 : 1;
  return line(j).keys[i] = answer.key;
}

// Corners of the block may be corners of the face: those are left to the cache itself.
const BorderCache::Stretch* Lattice::side(int i, int j) const {
  const bool inner_u = i > 0 && i < width_;
  const bool inner_v = j > 0 && j < height_;
  if (inner_u == inner_v) return nullptr;
  const auto& s = sides_[inner_u ? (j == 0 ? 0 : 2) : (i == 0 ? 3 : 1)];
  return s.first == nullptr ? nullptr : &s;
}

Lattice::Fixed Lattice::fixed(int i, int j) {
  const double u = parameter(u_at(i));
  const double v = parameter(v_at(j));
  const auto snapped = [&](const surface::Lane4& p) { return detail::snap_lanes(p, res_); };
  if (u == 0 || v == 0 || u == 1 || v == 1) return snapped(lanes(surface_->position(block_.face, u, v)));
  if (own_.patch != nullptr && i <= last_own_u_ && j <= last_own_v_) {
    return snapped(surface::cubic(row(j), own_.u(i)));
  }
  if (above_.patch != nullptr && j == height_ && i < width_) {
    if (!above_row_) above_row_ = above_.patch->row(above_.v(j));
    return snapped(surface::cubic(*above_row_, above_.u(i)));
  }
  if (right_.patch != nullptr && i == width_ && j < height_) {
    return snapped(surface::cubic(right_.patch->row(right_.v(j)), right_.u(i)));
  }
  if (const auto hit = pieces_->find(u, v); hit.patch != nullptr) {
    return snapped(surface::cubic(hit.patch->row(hit.v), hit.u));
  }
  return snapped(lanes(surface_->position(block_.face, u, v)));
}

Vec3 Lattice::unit_normal(int i, int j, std::uint64_t& nudged) {
  constexpr double kSmallestSine2 = 1e-12;
  if (own_.patch != nullptr) {
    Line& l = line(j);
    Row& slope = slopes_[static_cast<std::size_t>(j)];
    if (!l.slope_ready) {
      l.slope_ready = true;
      slope = own_.patch->row_slope(own_.v(j));
    }
    const Vec3 du = vec(surface::cubic_slope(row(j), own_.u(i)));
    const Vec3 dv = vec(surface::cubic(slope, own_.u(i)));
    const Vec3 n = du.cross(dv);
    if (n.length2() > kSmallestSine2 * du.length2() * dv.length2()) return n / n.length();
  }
  const auto n = surface_->unit_normal(block_.face, parameter(u_at(i)), parameter(v_at(j)));
  nudged += n.nudged ? 1 : 0;
  return n.direction;
}

Voxel Lattice::representative(int i, int j, std::uint64_t& nudged) {
  const VoxelKey k = key(i, j);
  Voxel v{};
  v.x = static_cast<std::uint16_t>(key_x(k));
  v.y = static_cast<std::uint16_t>(key_y(k));
  v.z = static_cast<std::uint16_t>(key_z(k));
  v.object = static_cast<std::uint16_t>(block_.object);
  v.face = block_.face;
  v.u = static_cast<float>(parameter(u_at(i)));
  v.v = static_cast<float>(parameter(v_at(j)));
  const Fixed p = fixed(i, j);
  const Vec3 n = unit_normal(i, j, nudged);
  for (int x = 0; x < 3; ++x) {
    v.point[x] = static_cast<float>(p[static_cast<std::size_t>(x)] & 0xffff) * 0x1p-16F;
    v.normal[x] = static_cast<float>(n[x]);
  }
  return v;
}

}  // namespace gnomon::voxel
