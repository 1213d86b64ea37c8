// SPDX-License-Identifier: Apache-2.0
// Refinement by Far; each face carries the parameters of its corners from the cage down.
#include "oracle.hpp"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <array>
#include <memory>

namespace gnomon::test {
namespace {

namespace far = OpenSubdiv::Far;
namespace sdc = OpenSubdiv::Sdc;

struct Point {
  Vec3 p{0, 0, 0};
  void Clear(void* = nullptr) { p = Vec3(0, 0, 0); }
  void AddWithWeight(const Point& s, double w) { p += s.p * w; }
};

struct FaceMap {
  int cage_face, corner;
  std::array<Vec2, 4> uv;
};

std::unique_ptr<far::TopologyRefiner> make(const scene::ControlMesh& m, int level) {
  std::vector<int> pairs;
  std::vector<float> weights;
  for (const auto& c : m.creases) {
    pairs.insert(pairs.end(), {c.v0, c.v1});
    weights.push_back(c.sharpness);
  }
  far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(m.positions.size());
  d.numFaces = static_cast<int>(m.face_sizes.size());
  d.numVertsPerFace = m.face_sizes.data();
  d.vertIndicesPerFace = m.face_indices.data();
  d.numCreases = static_cast<int>(weights.size());
  d.creaseVertexIndexPairs = pairs.data();
  d.creaseWeights = weights.data();
  sdc::Options options;
  options.SetVtxBoundaryInterpolation(m.boundary == scene::Boundary::EdgeOnly
                                          ? sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                          : sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  std::unique_ptr<far::TopologyRefiner> r(Factory::Create(d, Factory::Options(sdc::SCHEME_CATMARK, options)));
  far::TopologyRefiner::UniformOptions uniform(level);
  uniform.fullTopologyInLastLevel = true;
  r->RefineUniform(uniform);
  return r;
}

std::vector<Point> points_at(const far::TopologyRefiner& r, const scene::ControlMesh& m, int level) {
  std::vector<Point> coarse;
  coarse.reserve(m.positions.size());
  for (const Vec3& p : m.positions) coarse.push_back({p});
  for (int l = 1; l <= level; ++l) {
    std::vector<Point> fine(static_cast<std::size_t>(r.GetLevel(l).GetNumVertices()));
    far::PrimvarRefinerReal<double>(r).Interpolate(l, coarse, fine);
    coarse = std::move(fine);
  }
  return coarse;
}

// The children of a quad keep its orientation, those of another face start at its corner.
std::vector<FaceMap> refine_maps(const far::TopologyLevel& level, const std::vector<FaceMap>& maps,
                                 std::size_t count) {
  std::vector<FaceMap> out(count);
  for (int f = 0; f < level.GetNumFaces(); ++f) {
    const auto children = level.GetFaceChildFaces(f);
    for (int i = 0; i < children.size(); ++i) {
      FaceMap& child = out[static_cast<std::size_t>(children[i])];
      if (children.size() != 4) {
        child = {f, i, {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}};
        continue;
      }
      const FaceMap& parent = maps[static_cast<std::size_t>(f)];
      child = parent;
      for (std::size_t k = 0; k < 4; ++k) {
        child.uv[k] = (parent.uv[k] + parent.uv[static_cast<std::size_t>(i)]) * 0.5;
      }
    }
  }
  return out;
}

}  // namespace

std::vector<OraclePoint> refine_to_limit(const scene::ControlMesh& mesh, int level) {
  const auto refiner = make(mesh, level);
  const std::vector<Point> refined_points = points_at(*refiner, mesh, level);
  std::vector<Point> limit(refined_points.size());
  far::PrimvarRefinerReal<double>(*refiner).Limit(refined_points, limit);

  std::vector<FaceMap> maps;
  maps.reserve(mesh.face_sizes.size());
  for (int f = 0; f < refiner->GetLevel(0).GetNumFaces(); ++f) {
    maps.push_back({f, 0, {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}});
  }
  for (int l = 0; l < level; ++l) {
    maps = refine_maps(refiner->GetLevel(l), maps,
                       static_cast<std::size_t>(refiner->GetLevel(l + 1).GetNumFaces()));
  }
  std::vector<OraclePoint> out;
  for (int f = 0; f < refiner->GetLevel(level).GetNumFaces(); ++f) {
    const FaceMap& map = maps[static_cast<std::size_t>(f)];
    const auto vertices = refiner->GetLevel(level).GetFaceVertices(f);
    for (int k = 0; k < 4; ++k) {
      const Vec2 uv = map.uv[static_cast<std::size_t>(k)];
      out.push_back({map.cage_face, map.corner, uv.x, uv.y, limit[static_cast<std::size_t>(vertices[k])].p});
    }
  }
  return out;
}

scene::ControlMesh refined(const scene::ControlMesh& mesh, int level) {
  const auto refiner = make(mesh, level);
  scene::ControlMesh out;
  out.name = mesh.name;
  for (const Point& p : points_at(*refiner, mesh, level)) out.positions.push_back(p.p);
  const far::TopologyLevel& last = refiner->GetLevel(level);
  for (int f = 0; f < last.GetNumFaces(); ++f) {
    const auto vertices = last.GetFaceVertices(f);
    out.face_sizes.push_back(vertices.size());
    out.face_indices.insert(out.face_indices.end(), vertices.begin(), vertices.end());
  }
  return out;
}

}  // namespace gnomon::test
