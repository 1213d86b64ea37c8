// SPDX-License-Identifier: Apache-2.0
// The triangulation that pictures use, welded where faces share a border, its halved quads put together
// again.
#include "host/mesh/surface_mesh.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "host/mesh/subpatch_rects.hpp"
#include "host/metrics/parametric_mesh.hpp"
#include "host/metrics/voxel_index.hpp"
#include "host/surface/borders.hpp"

namespace gnomon::mesh {
namespace {

/// Where unit normals of two faces at one point count as the same: 0.1 degrees, far above rounding.
constexpr float kSameNormal = 0.9999985F;

Vec3 vec(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

/// A point on the border of some face, by what it is: faces that share it give the same (vertex, id, t).
struct BorderPoint {
  surface::BorderSpot spot;
  std::uint32_t point;
  auto place() const { return std::tie(spot.vertex, spot.id, spot.t); }
  auto order() const { return std::tie(spot.vertex, spot.id, spot.t, point); }
};

bool on_border(const std::array<float, 2>& uv) {
  return std::ranges::any_of(uv, [](float x) { return x == 0 || x == 1; });
}

/// One object's part of a mesh.
class ObjectMesh {
 public:
  ObjectMesh(const surface::LimitSurface& surface, const voxel::VoxelSet& voxels, const SubpatchRects& rects,
             SurfaceMesh& out)
      : voxels_(voxels), rects_(rects), out_(out) {
    const double middle = voxels.grid.res / 2.0;
    mesh_ = metrics::triangulate(surface, rects.rects, Vec3(middle, middle, middle), true);
    find_faces();
    weld(surface.borders());
    add_vertices();
    add_normals();
    add_faces();
  }

 private:
  void find_faces() {
    face_of_.resize(mesh_.points.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (const std::uint32_t corner : mesh_.triangles[t])
        face_of_[corner] = rects_.rects[mesh_.rect_of_triangle[t]].face;
  }

  /// vertex_of_[point]: the lowest point that is the same point of the surface, for now.
  void weld(const surface::Borders& borders) {
    vertex_of_.resize(mesh_.points.size());
    std::iota(vertex_of_.begin(), vertex_of_.end(), 0U);
    std::vector<BorderPoint> shared;
    for (std::uint32_t i = 0; i < mesh_.params.size(); ++i) {
      const auto& [u, v] = mesh_.params[i];
      if (on_border(mesh_.params[i])) shared.push_back({borders.spot(face_of_[i], double{u}, double{v}), i});
    }
    tbb::parallel_sort(shared.begin(), shared.end(),
                       [](const BorderPoint& a, const BorderPoint& b) { return a.order() < b.order(); });
    for (std::size_t i = 1; i < shared.size(); ++i) {
      if (shared[i].place() == shared[i - 1].place())
        vertex_of_[shared[i].point] = vertex_of_[shared[i - 1].point];
    }
  }

  void add_vertices() {
    const voxel::Grid& grid = voxels_.grid;
    for (std::uint32_t i = 0; i < vertex_of_.size(); ++i) {
      if (vertex_of_[i] != i) {
        vertex_of_[i] = vertex_of_[vertex_of_[i]];
        continue;
      }
      vertex_of_[i] = static_cast<std::uint32_t>(out_.positions.size());
      out_.positions.push_back(grid.origin + (vec(mesh_.points[i]) + mesh_.center) * grid.voxel_size);
    }
    out_.voxels.resize(out_.positions.size(), kNone);
  }

  /// Points of one vertex share a normal where their faces meet smoothly.
  void add_normals() {
    std::vector<std::uint32_t> sorted(mesh_.points.size());
    std::iota(sorted.begin(), sorted.end(), 0U);
    tbb::parallel_sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(vertex_of_[a], a) < std::tie(vertex_of_[b], b);
    });
    normal_of_.resize(sorted.size());
    std::size_t first = out_.normals.size();
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i > 0 && vertex_of_[sorted[i]] != vertex_of_[sorted[i - 1]]) first = out_.normals.size();
      normal_of_[sorted[i]] = normal_among(first, mesh_.normals[sorted[i]]);
    }
  }

  std::uint32_t normal_among(std::size_t first, const std::array<float, 3>& normal) {
    const auto same = [&](const std::array<float, 3>& other) {
      return normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2] >= kSameNormal;
    };
    const auto begin = out_.normals.begin() + static_cast<std::ptrdiff_t>(first);
    const auto found = std::find_if(begin, out_.normals.end(), same);
    const auto index = static_cast<std::uint32_t>(found - out_.normals.begin());
    if (found == out_.normals.end()) out_.normals.push_back(normal);
    return index;
  }

  /// A rectangle's triangles follow one another: two of them are its quad, cut from corner 0 to corner 2.
  void add_faces() {
    const auto& triangles = mesh_.triangles;
    for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
      const std::uint32_t rect = mesh_.rect_of_triangle[begin];
      while (end < triangles.size() && mesh_.rect_of_triangle[end] == rect) ++end;
      if (end - begin == 2) {
        add_face({triangles[begin][0], triangles[begin][1], triangles[begin][2], triangles[begin + 1][2]});
      } else {
        for (std::size_t t = begin; t < end; ++t)
          add_face({triangles[t][0], triangles[t][1], triangles[t][2], kNone});
      }
      for (std::size_t t = begin; t < end; ++t)
        for (const std::uint32_t point : triangles[t]) find_voxel(point, rect);
    }
  }

  void add_face(const Corners& points) {
    Corners vertices = points;
    Corners normals = points;
    for (std::size_t k = 0; k < corner_count(points); ++k) {
      vertices[k] = vertex_of_[points[k]];
      normals[k] = normal_of_[points[k]];
    }
    out_.faces.push_back(vertices);
    out_.face_normals.push_back(normals);
  }

  void find_voxel(std::uint32_t point, std::uint32_t rect) {
    const metrics::ParamRect& r = rects_.rects[rect];
    const auto& [u, v] = mesh_.params[point];
    const bool corner = (u == r.u0 || u == r.u1) && (v == r.v0 || v == r.v1);
    if (!corner) return;
    const std::size_t number = v == r.v1 ? (u == r.u1 ? 2 : 3) : (u == r.u1 ? 1 : 0);
    out_.voxels[vertex_of_[point]] = voxels_.subpatches[rects_.subpatches[rect]].corner[number];
  }

  const voxel::VoxelSet& voxels_;
  const SubpatchRects& rects_;
  SurfaceMesh& out_;
  metrics::ParametricMesh mesh_;
  std::vector<std::uint32_t> face_of_, vertex_of_, normal_of_;  // by point of mesh_
};

/// The middles of triangle fans are no subpatch's corner.
void find_remaining_voxels(SurfaceMesh& mesh, const voxel::VoxelSet& voxels) {
  const metrics::VoxelIndex index(voxels);
  for (std::size_t i = 0; i < mesh.voxels.size(); ++i) {
    if (mesh.voxels[i] == kNone)
      mesh.voxels[i] = index.answering((mesh.positions[i] - voxels.grid.origin) / voxels.grid.voxel_size);
  }
}

}  // namespace

SurfaceMesh surface_mesh(std::span<const surface::LimitSurface> surfaces, const voxel::VoxelSet& voxels,
                         std::span<const std::string> names) {
  if (voxels.subpatches.empty()) throw std::invalid_argument("a mesh needs the voxelizer's subpatches");
  if (names.size() != surfaces.size()) throw std::invalid_argument("every object of a mesh needs a name");
  SurfaceMesh out;
  out.spacing = voxels.grid.voxel_size;
  const std::vector<SubpatchRects> rects = subpatch_rects(voxels, surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    out.objects.push_back({names[i], out.faces.size()});
    ObjectMesh(surfaces[i], voxels, rects[i], out);
  }
  find_remaining_voxels(out, voxels);
  return out;
}

std::vector<std::array<float, 3>> vertex_normals(const SurfaceMesh& mesh) {
  std::vector<Vec3> sums(mesh.positions.size(), Vec3(0, 0, 0));
  std::vector<std::array<float, 3>> any(mesh.positions.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < corner_count(mesh.faces[f]); ++k) {
      any[mesh.faces[f][k]] = mesh.normals[mesh.face_normals[f][k]];
      sums[mesh.faces[f][k]] += vec(mesh.normals[mesh.face_normals[f][k]]);
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    // Where the normals cancel, one of them is as good as another.
    if (sums[i].length() < 1e-6) continue;
    const Vec3 mean = sums[i].normalized();
    any[i] = {static_cast<float>(mean.x), static_cast<float>(mean.y), static_cast<float>(mean.z)};
  }
  return any;
}

std::vector<std::uint8_t> vertex_shadows(const SurfaceMesh& mesh,
                                         std::span<const golden::VoxelState> states) {
  std::vector<std::uint8_t> shadows(mesh.voxels.size());
  for (std::size_t i = 0; i < shadows.size(); ++i) {
    const std::uint32_t voxel = mesh.voxels[i];
    shadows[i] = voxel != kNone && states[voxel] == golden::VoxelState::Shadow ? 1 : 0;
  }
  return shadows;
}

}  // namespace gnomon::mesh
