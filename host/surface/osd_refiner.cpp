// SPDX-License-Identifier: Apache-2.0
// Hands a cage to OpenSubdiv.
#include "host/surface/osd_refiner.hpp"

#include <opensubdiv/far/topologyDescriptor.h>

#include <stdexcept>

namespace gnomon::surface {
namespace {

namespace far = OpenSubdiv::Far;
namespace sdc = OpenSubdiv::Sdc;

sdc::Options scheme_options(scene::Boundary boundary) {
  sdc::Options options;
  switch (boundary) {
    case scene::Boundary::None:
      options.SetVtxBoundaryInterpolation(sdc::Options::VTX_BOUNDARY_NONE);
      break;
    case scene::Boundary::EdgeOnly:
      options.SetVtxBoundaryInterpolation(sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
      break;
    case scene::Boundary::EdgeAndCorner:
      options.SetVtxBoundaryInterpolation(sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
      break;
  }
  return options;
}

}  // namespace

std::unique_ptr<far::TopologyRefiner> make_refiner(const Cage& cage) {
  std::vector<int> crease_vertices;
  std::vector<float> crease_weights;
  for (const auto& c : cage.creases) {
    crease_vertices.insert(crease_vertices.end(), {c.v0, c.v1});
    crease_weights.push_back(c.sharpness);
  }
  std::vector<int> corner_vertices;
  std::vector<float> corner_weights;
  for (const auto& c : cage.corners) {
    corner_vertices.push_back(c.v);
    corner_weights.push_back(c.sharpness);
  }
  std::vector<int> holes;
  for (int f = 0; f < cage.face_count(); ++f) {
    if (cage.hole[static_cast<std::size_t>(f)]) holes.push_back(f);
  }

  far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(cage.positions.size());
  d.numFaces = cage.face_count();
  d.numVertsPerFace = cage.sizes.data();
  d.vertIndicesPerFace = cage.indices.data();
  d.numCreases = static_cast<int>(crease_weights.size());
  d.creaseVertexIndexPairs = crease_vertices.data();
  d.creaseWeights = crease_weights.data();
  d.numCorners = static_cast<int>(corner_weights.size());
  d.cornerVertexIndices = corner_vertices.data();
  d.cornerWeights = corner_weights.data();
  d.numHoles = static_cast<int>(holes.size());
  d.holeIndices = holes.data();

  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  std::unique_ptr<far::TopologyRefiner> refiner(
      Factory::Create(d, Factory::Options(sdc::SCHEME_CATMARK, scheme_options(cage.boundary))));
  if (!refiner) throw std::runtime_error("OpenSubdiv refused a cage that passed our checks");
  return refiner;
}

}  // namespace gnomon::surface
