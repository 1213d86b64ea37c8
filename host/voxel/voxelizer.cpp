// SPDX-License-Identifier: Apache-2.0
// The recursion over every face, and the merging of what the faces found.
#include "host/voxel/voxelizer.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <unordered_map>

#include "host/voxel/voxel_key.hpp"

namespace gnomon::voxel {
namespace {

constexpr int kMaxLevels = 24;

struct Point {
  VoxelKey key;
  std::uint32_t u, v;  // in units of 2^-24
};

struct Leaf {
  std::uint32_t u0, v0, u1, v1;
  std::array<VoxelKey, 4> corner;
};

struct FaceVoxels {
  std::vector<Point> points;
  std::vector<Leaf> leaves;
  std::uint64_t floor_hits = 0;
};

template <Adjacency kAdjacency>
class FaceRecursion {
 public:
  FaceRecursion(const surface::LimitSurface& s, std::uint32_t face, double res, int floor)
      : surface_(s), face_(face), res_(res), floor_(floor) {}

  FaceVoxels run() {
    constexpr std::uint32_t kOne = 1u << kMaxLevels;
    cell(0, 0, kOne, kOne);
    return std::move(out_);
  }

 private:
  VoxelKey at(std::uint32_t u, std::uint32_t v) {
    const auto [it, fresh] = seen_.try_emplace(std::uint64_t{v} << 32 | u);
    if (fresh) {
      const Vec3 p = surface_.position(face_, std::ldexp(u, -kMaxLevels), std::ldexp(v, -kMaxLevels));
      it->second = pack(snap(p.x, res_) >> kFractionBits, snap(p.y, res_) >> kFractionBits,
                        snap(p.z, res_) >> kFractionBits);
      out_.points.push_back({it->second, u, v});
    }
    return it->second;
  }

  void cell(std::uint32_t u0, std::uint32_t v0, std::uint32_t u1, std::uint32_t v1) {
    const std::array c{at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)};
    constexpr auto kN = kAdjacency;
    bool split_u = (gap<kN>(c[0], c[1]) | gap<kN>(c[3], c[2])) != 0;
    bool split_v = (gap<kN>(c[0], c[3]) | gap<kN>(c[1], c[2])) != 0;
    if (!split_u && !split_v && gap<kN>(c[0], c[2]) != 0 && gap<kN>(c[1], c[3]) != 0) {
      split_u = u1 - u0 >= v1 - v0;
      split_v = !split_u;
    }
    const std::uint32_t smallest = 1u << (kMaxLevels - floor_);
    const bool floored = (split_u && u1 - u0 <= smallest) || (split_v && v1 - v0 <= smallest);
    if (floored || !(split_u || split_v)) {
      out_.floor_hits += floored ? 1 : 0;
      out_.leaves.push_back({u0, v0, u1, v1, c});
      return;
    }
    const std::uint32_t um = (u0 + u1) / 2;
    const std::uint32_t vm = (v0 + v1) / 2;
    if (split_u && split_v) {
      cell(u0, v0, um, vm);
      cell(um, v0, u1, vm);
      cell(u0, vm, um, v1);
      cell(um, vm, u1, v1);
    } else if (split_u) {
      cell(u0, v0, um, v1);
      cell(um, v0, u1, v1);
    } else {
      cell(u0, v0, u1, vm);
      cell(u0, vm, u1, v1);
    }
  }

  const surface::LimitSurface& surface_;
  std::uint32_t face_;
  double res_;
  int floor_;
  std::unordered_map<std::uint64_t, VoxelKey> seen_;
  FaceVoxels out_;
};

float parameter(std::uint32_t i) {
  return std::ldexp(static_cast<float>(i), -kMaxLevels);
}

}  // namespace

Result<VoxelSet> voxelize(std::span<const surface::LimitSurface> surfaces, const Grid& grid,
                          const VoxelizerOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const double res = grid.res;
  for (const auto& s : surfaces) {
    const Box3 b = s.bounds();
    if (!(b.min.x >= 0 && b.min.y >= 0 && b.min.z >= 0 && b.max.x <= res && b.max.y <= res &&
          b.max.z <= res)) {
      return fail(fmt::format("a surface leaves the grid of {} voxels a side", grid.res));
    }
  }
  const int floor_level = std::min(kMaxLevels, static_cast<int>(std::ceil(std::log2(res) / 0.6)) + 2);
  VoxelSet set;
  set.grid = grid;
  std::unordered_map<VoxelKey, std::uint32_t> index;
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                             : static_cast<int>(options.threads));
  std::uint64_t total_faces = 0;
  std::uint64_t done_faces = 0;
  for (const auto& s : surfaces) total_faces += s.face_count();
  for (std::uint32_t object = 0; object < surfaces.size(); ++object) {
    const auto& s = surfaces[object];
    std::vector<FaceVoxels> found(s.face_count());
    arena.execute([&] {
      tbb::parallel_for(std::uint32_t{0}, s.face_count(), [&](std::uint32_t face) {
        switch (grid.adjacency) {
          case Adjacency::N18:
            found[face] = FaceRecursion<Adjacency::N18>(s, face, res, floor_level).run();
            break;
          default:
            found[face] = FaceRecursion<Adjacency::N26>(s, face, res, floor_level).run();
            break;
        }
      });
    });
    for (std::uint32_t face = 0; face < s.face_count(); ++face) {
      FaceVoxels& f = found[face];
      set.statistics.evaluations += f.points.size();
      set.statistics.floor_hits += f.floor_hits;
      set.statistics.subpatches += f.leaves.size();
      std::sort(f.points.begin(), f.points.end(),
                [](const Point& a, const Point& b) { return a.v != b.v ? a.v < b.v : a.u < b.u; });
      for (const Point& p : f.points) {
        if (!index.try_emplace(p.key, static_cast<std::uint32_t>(set.voxels.size())).second) continue;
        Voxel voxel{};
        voxel.x = static_cast<std::uint16_t>(key_x(p.key));
        voxel.y = static_cast<std::uint16_t>(key_y(p.key));
        voxel.z = static_cast<std::uint16_t>(key_z(p.key));
        voxel.object = static_cast<std::uint16_t>(object);
        voxel.face = face;
        voxel.u = parameter(p.u);
        voxel.v = parameter(p.v);
        if (options.representatives) {
          const Vec3 q = s.position(face, voxel.u, voxel.v);
          const auto n = s.unit_normal(face, voxel.u, voxel.v);
          set.statistics.zero_normals += n.nudged ? 1 : 0;
          for (int k = 0; k < 3; ++k) {
            voxel.point[k] = std::ldexp(static_cast<float>(snap(q[k], res) & 0xffff), -kFractionBits);
            voxel.normal[k] = static_cast<float>(n.direction[k]);
          }
        }
        set.voxels.push_back(voxel);
      }
      if (options.subpatches) {
        for (const Leaf& l : f.leaves) {
          set.subpatches.push_back(
              {object,
               face,
               parameter(l.u0),
               parameter(l.v0),
               parameter(l.u1),
               parameter(l.v1),
               {index.at(l.corner[0]), index.at(l.corner[1]), index.at(l.corner[2]), index.at(l.corner[3])}});
        }
      }
      if (options.progress)
        options.progress(static_cast<double>(++done_faces) / static_cast<double>(total_faces));
    }
  }
  set.statistics.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return set;
}

}  // namespace gnomon::voxel
