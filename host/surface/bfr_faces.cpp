// SPDX-License-Identifier: Apache-2.0
// Sets up one Bfr surface per cage face, and evaluates it.
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/bfr/surface.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <shared_mutex>

#include "host/surface/face_source.hpp"
#include "host/surface/osd_refiner.hpp"
#include "host/surface/osd_warnings.hpp"

namespace gnomon::surface {
namespace {

namespace bfr = OpenSubdiv::Bfr;

using Cache = bfr::SurfaceFactoryCacheThreaded<std::shared_mutex, std::shared_lock<std::shared_mutex>,
                                               std::unique_lock<std::shared_mutex>>;
using Factory = bfr::RefinerSurfaceFactory<Cache>;

bfr::Surface<double>::PointDescriptor packed() {
  return {3, 3};
}

struct Coordinates {
  double uv[2];
};

Coordinates face_coordinates(const bfr::Surface<double>& s, int sub_face, double u, double v) {
  if (sub_face < 0) return {{u, v}};
  const double in[2] = {u, v};
  Coordinates out{};
  s.GetParameterization().ConvertNormalizedSubFaceToCoord(sub_face, in, out.uv);
  return out;
}

class BfrFaces final : public FaceSource {
 public:
  explicit BfrFaces(const Cage& cage);

  bool valid(int cage_face) const override {
    return surfaces_[static_cast<std::size_t>(cage_face)].IsValid();
  }
  bool regular(int cage_face) const override {
    return surfaces_[static_cast<std::size_t>(cage_face)].IsRegular();
  }
  Vec3 position(ParametricFace face, double u, double v) const override;
  SurfacePoint evaluate(ParametricFace face, double u, double v) const override;
  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  const double* points(int cage_face) const {
    return points_.data() + first_point_[static_cast<std::size_t>(cage_face)];
  }

  std::vector<bfr::Surface<double>> surfaces_;
  std::vector<std::size_t> first_point_;  // of each face in points_, counted in doubles
  std::vector<double> points_;            // patch points, x y z
  std::vector<std::string> warnings_;
};

BfrFaces::BfrFaces(const Cage& cage) {
  OsdWarnings collected;
  const auto refiner = make_refiner(cage);
  const Factory factory(*refiner, Factory::Options()
                                      .SetApproxLevelSmooth(kApproximationLevel)
                                      .SetApproxLevelSharp(kApproximationLevel)
                                      .EnableCaching(true));
  const auto n = static_cast<std::size_t>(cage.face_count());
  surfaces_.resize(n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n), [&](const auto& range) {
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      if (!cage.hole[f]) factory.InitVertexSurface(static_cast<int>(f), &surfaces_[f]);
    }
  });
  std::size_t total = 0;
  first_point_.reserve(n);
  for (const auto& s : surfaces_) {
    first_point_.push_back(total);
    if (s.IsValid()) total += 3 * static_cast<std::size_t>(s.GetNumPatchPoints());
  }
  points_.resize(total);
  const double* mesh_points = &cage.positions[0].x;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n), [&](const auto& range) {
    for (std::size_t f = range.begin(); f != range.end(); ++f) {
      if (!surfaces_[f].IsValid()) continue;
      surfaces_[f].PreparePatchPoints(mesh_points, packed(), points_.data() + first_point_[f], packed());
    }
  });
  warnings_ = collected.take();
}

Vec3 BfrFaces::position(ParametricFace face, double u, double v) const {
  const auto& s = surfaces_[static_cast<std::size_t>(face.cage_face)];
  const Coordinates c = face_coordinates(s, face.sub_face, u, v);
  Vec3 p;
  s.Evaluate(c.uv, points(face.cage_face), packed(), &p.x);
  return p;
}

SurfacePoint BfrFaces::evaluate(ParametricFace face, double u, double v) const {
  const auto& s = surfaces_[static_cast<std::size_t>(face.cage_face)];
  const Coordinates c = face_coordinates(s, face.sub_face, u, v);
  SurfacePoint p;
  s.Evaluate(c.uv, points(face.cage_face), packed(), &p.position.x, &p.du.x, &p.dv.x);
  if (face.sub_face >= 0) {  // a part of an n-gon spans half of its face's coordinate
    p.du *= 0.5;
    p.dv *= 0.5;
  }
  return p;
}

}  // namespace

std::unique_ptr<FaceSource> make_bfr_faces(const Cage& cage) {
  return std::make_unique<BfrFaces>(cage);
}

}  // namespace gnomon::surface
