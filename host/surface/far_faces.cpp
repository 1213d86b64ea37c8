// SPDX-License-Identifier: Apache-2.0
// The limit surface from Far's adaptive patch table, for cages that Bfr cannot be trusted with.
#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "host/surface/face_source.hpp"
#include "host/surface/osd_refiner.hpp"
#include "host/surface/osd_warnings.hpp"

namespace gnomon::surface {
namespace {

namespace far = OpenSubdiv::Far;

struct Point {
  Vec3 p{0, 0, 0};
  void Clear(void* = nullptr) { p = Vec3(0, 0, 0); }
  void AddWithWeight(const Point& src, double weight) { p += src.p * weight; }
};

class FarFaces final : public FaceSource {
 public:
  explicit FarFaces(const Cage& cage) {
    OsdWarnings collected;
    const auto refiner = make_refiner(cage);
    far::PatchTableFactory::Options options(kApproximationLevel);
    options.SetPatchPrecision<double>();
    options.useInfSharpPatch = true;
    options.endCapType = far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS;
    auto adaptive = options.GetRefineAdaptiveOptions();
    adaptive.isolationLevel = kApproximationLevel;
    adaptive.secondaryLevel = kApproximationLevel;
    refiner->RefineAdaptive(adaptive);
    table_.reset(far::PatchTableFactory::Create(*refiner, options));
    map_ = std::make_unique<far::PatchMap>(*table_);
    compute_points(cage, *refiner);

    const far::PtexIndices ptex(*refiner);
    for (int f = 0; f < cage.face_count(); ++f) {
      first_ptex_.push_back(ptex.GetFaceId(f));
      valid_.push_back(!cage.hole[static_cast<std::size_t>(f)] &&
                       map_->FindPatch(ptex.GetFaceId(f), 0.5, 0.5) != nullptr);
    }
    warnings_ = collected.take();
  }

  bool valid(int cage_face) const override { return valid_[static_cast<std::size_t>(cage_face)]; }
  bool regular(int) const override { return false; }
  Vec3 position(ParametricFace face, double u, double v) const override {
    return evaluate(face, u, v).position;
  }

  SurfacePoint evaluate(ParametricFace face, double u, double v) const override {
    const int ptex = first_ptex_[static_cast<std::size_t>(face.cage_face)] + std::max(face.sub_face, 0);
    const far::PatchTable::PatchHandle& handle = *map_->FindPatch(ptex, u, v);
    std::array<double, kLargestPatch> p;
    std::array<double, kLargestPatch> du;
    std::array<double, kLargestPatch> dv;
    table_->EvaluateBasis(handle, u, v, p.data(), du.data(), dv.data());
    SurfacePoint out{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const auto vertices = table_->GetPatchVertices(handle);
    for (int i = 0; i < vertices.size(); ++i) {
      const auto w = static_cast<std::size_t>(i);
      const Vec3& x = points_[static_cast<std::size_t>(vertices[i])].p;
      out.position += x * p[w];
      out.du += x * du[w];
      out.dv += x * dv[w];
    }
    return out;
  }

  const std::vector<std::string>& warnings() const override { return warnings_; }

 private:
  static constexpr std::size_t kLargestPatch = 20;  // a Gregory patch

  void compute_points(const Cage& cage, const far::TopologyRefiner& refiner) {
    const auto refined = static_cast<std::size_t>(refiner.GetNumVerticesTotal());
    points_.resize(refined + static_cast<std::size_t>(table_->GetNumLocalPoints()));
    std::transform(cage.positions.begin(), cage.positions.end(), points_.begin(),
                   [](const Vec3& p) { return Point{p}; });
    Point* source = points_.data();
    for (int level = 1; level < refiner.GetNumLevels(); ++level) {
      Point* target = source + refiner.GetLevel(level - 1).GetNumVertices();
      far::PrimvarRefinerReal<double>(refiner).Interpolate(level, source, target);
      source = target;
    }
    if (table_->GetNumLocalPoints() > 0) {
      table_->GetLocalPointStencilTable<double>()->UpdateValues(points_.data(), points_.data() + refined);
    }
  }

  std::unique_ptr<far::PatchTable> table_;
  std::unique_ptr<far::PatchMap> map_;
  std::vector<Point> points_;  // all levels, then the local points of the patches
  std::vector<int> first_ptex_;
  std::vector<bool> valid_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::unique_ptr<FaceSource> make_far_faces(const Cage& cage) {
  return std::make_unique<FarFaces>(cage);
}

bool trips_bfr(const Cage& cage) {
  std::vector<int> valence(cage.positions.size(), 0);
  for (const int v : cage.indices) ++valence[static_cast<std::size_t>(v)];
  // An edge used by one face alone is a boundary; valence 2 between two boundary edges is harmless.
  std::set<std::pair<int, int>> boundary;
  const auto for_each_edge = [&](auto&& visit) {
    for (int f = 0; f < cage.face_count(); ++f) {
      const auto face = cage.face(f);
      for (std::size_t k = 0; k < face.size(); ++k) visit(std::minmax(face[k], face[(k + 1) % face.size()]));
    }
  };
  for_each_edge([&](std::pair<int, int> e) {
    if (const auto [it, fresh] = boundary.insert(e); !fresh) boundary.erase(it);
  });
  std::vector<bool> open(cage.positions.size(), false);
  for (const auto& [a, b] : boundary)
    open[static_cast<std::size_t>(a)] = open[static_cast<std::size_t>(b)] = true;
  for (std::size_t v = 0; v < valence.size(); ++v) {
    if (valence[v] == 2 && !open[v]) return true;
  }
  return false;
}

}  // namespace gnomon::surface
