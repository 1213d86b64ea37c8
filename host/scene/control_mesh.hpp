// SPDX-License-Identifier: Apache-2.0
// A Catmull-Clark control cage as the modeller wrote it, checked but not yet refined.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/base/vec.hpp"

namespace gnomon::scene {

/// What happens where a surface ends, as in OpenSubdiv's Sdc::Options::VtxBoundaryInterpolation.
enum class Boundary : std::uint8_t { None, EdgeOnly, EdgeAndCorner };

/// One object's control cage. Indices are 0-based into `positions`; every face has at least three different
/// vertices and finite coordinates (the reader refuses anything else).
struct ControlMesh {
  struct Crease {
    std::int32_t v0, v1;
    float sharpness;  ///< 0..10; 10 is infinitely sharp
  };
  struct Corner {
    std::int32_t v;
    float sharpness;  ///< 0..10; 10 is infinitely sharp
  };

  std::string name;
  std::vector<Vec3> positions;
  std::vector<std::int32_t> face_sizes;    ///< vertices of each face
  std::vector<std::int32_t> face_indices;  ///< all faces' vertices, one after the other
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  std::vector<std::int32_t> holes;  ///< faces that are not part of the surface
  Boundary boundary = Boundary::EdgeAndCorner;
};

}  // namespace gnomon::scene
