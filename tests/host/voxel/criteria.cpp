// SPDX-License-Identifier: Apache-2.0
// Flood fills and dense sampling.
#include "criteria.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace gnomon::test {
namespace {

using Step = std::array<std::int64_t, 3>;

std::vector<Step> steps(int neighbours) {
  std::vector<Step> out;
  for (std::int64_t i = 0; i < 27; ++i) {
    const Step s{i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
    const auto length = std::abs(s[0]) + std::abs(s[1]) + std::abs(s[2]);
    if (length > 0 && (neighbours == 26 || length == 1)) out.push_back(s);
  }
  return out;
}

bool within(const DenseGrid& g, std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto ok = [&](std::int64_t c) { return c >= -1 && c <= g.res(); };
  return ok(x) && ok(y) && ok(z);
}

template <class Visit>
void for_each_cell(const DenseGrid& g, Visit visit) {
  for (std::int64_t z = 0; z < g.res(); ++z) {
    for (std::int64_t y = 0; y < g.res(); ++y) {
      for (std::int64_t x = 0; x < g.res(); ++x) visit(x, y, z);
    }
  }
}

std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
  return static_cast<std::uint64_t>((z << 42) + (y << 21) + x);
}

// How many samples a face needs along u and v.
std::array<int, 2> samples_of(const surface::LimitSurface& s, std::uint32_t face, double spacing) {
  constexpr int kCoarse = 32;
  const auto at = [&](int i, int j) {
    return s.position(face, static_cast<double>(i) / kCoarse, static_cast<double>(j) / kCoarse);
  };
  double u = 0;
  double v = 0;
  for (int i = 0; i < kCoarse; ++i) {
    for (int j = 0; j < kCoarse; ++j) {
      u = std::max(u, kCoarse * (at(i + 1, j) - at(i, j)).length());
      v = std::max(v, kCoarse * (at(i, j + 1) - at(i, j)).length());
    }
  }
  return {std::max(2, static_cast<int>(1.2 * u / spacing)), std::max(2, static_cast<int>(1.2 * v / spacing))};
}

template <class Visit>
void for_each_sample(const surface::LimitSurface& s, double spacing, Visit visit) {
  for (std::uint32_t f = 0; f < s.face_count(); ++f) {
    const auto [nu, nv] = samples_of(s, f, spacing);
    for (int i = 0; i <= nu; ++i) {
      for (int j = 0; j <= nv; ++j)
        visit(s.position(f, static_cast<double>(i) / nu, static_cast<double>(j) / nv));
    }
  }
}

}  // namespace

DenseGrid::DenseGrid(const voxel::VoxelSet& set) : DenseGrid(set.grid.res) {
  for (const auto& v : set.voxels) at(v.x, v.y, v.z) = 1;
}

DenseGrid DenseGrid::outside(int neighbours) const {
  DenseGrid reached(static_cast<std::uint32_t>(res()));
  const auto offsets = steps(neighbours);
  std::vector<Step> todo{{-1, -1, -1}};
  reached.at(-1, -1, -1) = 1;
  while (!todo.empty()) {
    const Step c = todo.back();
    todo.pop_back();
    for (const Step& o : offsets) {
      const Step n{c[0] + o[0], c[1] + o[1], c[2] + o[2]};
      if (!within(*this, n[0], n[1], n[2]) || at(n[0], n[1], n[2]) != 0 || reached.at(n[0], n[1], n[2]) != 0)
        continue;
      reached.at(n[0], n[1], n[2]) = 1;
      todo.push_back(n);
    }
  }
  return reached;
}

DenseGrid DenseGrid::dilated() const {
  DenseGrid out(static_cast<std::uint32_t>(res()));
  const auto offsets = steps(26);
  for_each_cell(*this, [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    if (at(x, y, z) == 0) return;
    out.at(x, y, z) = 1;
    for (const Step& o : offsets) {
      if (within(out, x + o[0], y + o[1], z + o[2])) out.at(x + o[0], y + o[1], z + o[2]) = 1;
    }
  });
  return out;
}

int crossing_steps(voxel::Adjacency adjacency) {
  return adjacency == voxel::Adjacency::N6 ? 26 : 6;
}

namespace {

// What a flood through the empty cells of a thickened set leaves over, in connected pieces.
std::vector<std::vector<Step>> enclosed_pieces(const DenseGrid& thick) {
  DenseGrid seen = thick.outside(6);
  std::vector<std::vector<Step>> pieces;
  for_each_cell(thick, [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    if (thick.at(x, y, z) != 0 || seen.at(x, y, z) != 0) return;
    std::vector<Step> piece{{x, y, z}};
    seen.at(x, y, z) = 1;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      for (const Step& o : steps(6)) {
        const Step n{piece[i][0] + o[0], piece[i][1] + o[1], piece[i][2] + o[2]};
        if (!within(thick, n[0], n[1], n[2]) || thick.at(n[0], n[1], n[2]) != 0 ||
            seen.at(n[0], n[1], n[2]) != 0)
          continue;
        seen.at(n[0], n[1], n[2]) = 1;
        piece.push_back(n);
      }
    }
    pieces.push_back(std::move(piece));
  });
  return pieces;
}

// A narrow bay of the outside is enclosed by the thickened set too: the normals of the voxels around it point
// into it.
class Sides {
 public:
  explicit Sides(const voxel::VoxelSet& set) {
    for (const auto& v : set.voxels) voxels_[key(v.x, v.y, v.z)] = &v;
  }

  bool is_inside(const std::vector<Step>& piece) const {
    std::int64_t votes = 0;
    for (const Step& c : piece) {
      votes += vote(c);
      if (std::abs(votes) > 1000) break;
    }
    return votes > 0;
  }

 private:
  static constexpr std::int64_t kReach = 3;

  // The nearest voxel's opinion: 1 if the cell lies behind it, -1 if before it, 0 if there is none near.
  std::int64_t vote(const Step& c) const {
    double nearest = std::numeric_limits<double>::infinity();
    std::int64_t opinion = 0;
    for (std::int64_t n = 0; n < 343; ++n) {
      const Step d{c[0] + n % 7 - kReach, c[1] + n / 7 % 7 - kReach, c[2] + n / 49 - kReach};
      if (std::min({d[0], d[1], d[2]}) < 0) continue;
      const auto it = voxels_.find(key(d[0], d[1], d[2]));
      if (it == voxels_.end()) continue;
      const voxel::Voxel& v = *it->second;
      const Vec3 away =
          Vec3(static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])) + Vec3(0.5) -
          Vec3(v.x, v.y, v.z) - Vec3(v.point[0], v.point[1], v.point[2]);
      if (away.length2() >= nearest) continue;
      nearest = away.length2();
      opinion = away.dot(Vec3(v.normal[0], v.normal[1], v.normal[2])) < 0 ? 1 : -1;
    }
    return opinion;
  }

  std::unordered_map<std::uint64_t, const voxel::Voxel*> voxels_;
};

}  // namespace

Separation separation(const voxel::VoxelSet& set) {
  const DenseGrid grid(set);
  const DenseGrid reached = grid.outside(crossing_steps(set.grid.adjacency));
  const Sides sides(set);
  Separation out;
  for (const auto& piece : enclosed_pieces(grid.dilated())) {
    if (!sides.is_inside(piece)) {
      out.bays += piece.size();
      continue;
    }
    out.inside += piece.size();
    for (const Step& c : piece) out.leaks += reached.at(c[0], c[1], c[2]);
  }
  return out;
}

Coverage coverage(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& set,
                  double spacing) {
  std::unordered_map<std::uint64_t, double>
      nearest;  // squared distance of each set voxel's centre to a sample
  nearest.reserve(2 * set.voxels.size());
  for (const auto& v : set.voxels) nearest[key(v.x, v.y, v.z)] = std::numeric_limits<double>::infinity();
  Coverage out;
  std::uint64_t own = 0;
  for (const auto& s : surfaces) {
    for_each_sample(s, spacing, [&](const Vec3& p) {
      const Step c{static_cast<std::int64_t>(std::floor(p.x)), static_cast<std::int64_t>(std::floor(p.y)),
                   static_cast<std::int64_t>(std::floor(p.z))};
      ++out.samples;
      own += nearest.contains(key(c[0], c[1], c[2])) ? 1U : 0U;
      bool covered = false;
      for (std::int64_t n = 0; n < 27; ++n) {
        const Step d{c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1};
        if (std::min({d[0], d[1], d[2]}) < 0) continue;
        const auto it = nearest.find(key(d[0], d[1], d[2]));
        if (it == nearest.end()) continue;
        covered = true;
        const Vec3 centre(static_cast<double>(d[0]) + 0.5, static_cast<double>(d[1]) + 0.5,
                          static_cast<double>(d[2]) + 0.5);
        it->second = std::min(it->second, (centre - p).length2());
      }
      out.uncovered += covered ? 0 : 1;
    });
  }
  for (const auto& [k, d] : nearest) out.farthest_centre = std::max(out.farthest_centre, std::sqrt(d));
  out.own_voxel = static_cast<double>(own) / static_cast<double>(out.samples);
  return out;
}

std::uint64_t duplicates(const voxel::VoxelSet& set) {
  std::vector<std::uint64_t> keys;
  for (const auto& v : set.voxels) keys.push_back(key(v.x, v.y, v.z));
  std::sort(keys.begin(), keys.end());
  return keys.size() - static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
}

double surplus(const voxel::VoxelSet& set) {
  const auto offsets = steps(crossing_steps(set.grid.adjacency));
  const DenseGrid reached = DenseGrid(set).outside(crossing_steps(set.grid.adjacency));
  constexpr std::uint8_t kVoxel = 0;
  constexpr std::uint8_t kOutside = 1;
  constexpr std::uint8_t kInside = 2;
  DenseGrid label(set.grid.res);
  for (std::int64_t z = -1; z <= label.res(); ++z) {
    for (std::int64_t y = -1; y <= label.res(); ++y) {
      for (std::int64_t x = -1; x <= label.res(); ++x)
        label.at(x, y, z) = reached.at(x, y, z) != 0 ? kOutside : kInside;
    }
  }
  for (const auto& v : set.voxels) label.at(v.x, v.y, v.z) = kVoxel;
  std::uint64_t removed = 0;
  for (std::uint64_t before = ~std::uint64_t{0}; before != removed;) {
    before = removed;
    for (const auto& v : set.voxels) {
      if (label.at(v.x, v.y, v.z) != kVoxel) continue;
      bool sees_outside = false;
      bool sees_inside = false;
      for (const Step& o : offsets) {
        const auto l = label.at(v.x + o[0], v.y + o[1], v.z + o[2]);
        sees_outside = sees_outside || l == kOutside;
        sees_inside = sees_inside || l == kInside;
      }
      if (sees_outside && sees_inside) continue;
      label.at(v.x, v.y, v.z) = sees_outside ? kOutside : kInside;
      ++removed;
    }
  }
  const auto left = static_cast<double>(set.voxels.size() - removed);
  return left == 0 ? 0 : static_cast<double>(removed) / left;
}

}  // namespace gnomon::test
