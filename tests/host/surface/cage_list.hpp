// SPDX-License-Identifier: Apache-2.0
// Every kind of cage the surface and the voxelizer must bear, by name.
#pragma once

#include <string>
#include <vector>

#include "cages.hpp"

namespace gnomon::test {

struct NamedCage {
  std::string name;
  scene::ControlMesh mesh;
  bool closed = true;
  bool separating = true;  ///< closed, and no two sheets of it coincide
};

inline scene::ControlMesh with_crease(scene::ControlMesh mesh, float sharpness) {
  crease_face(mesh, 0, sharpness);
  return mesh;
}

inline std::vector<NamedCage> all_cages() {
  std::vector<NamedCage> cages;
  for (const int n : {2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 20, 27, 35, 50}) {
    cages.push_back({"valence" + std::to_string(n), spindle(n)});
  }
  for (const int n : {3, 5, 6, 9}) cages.push_back({"prism" + std::to_string(n), prism(n)});
  for (const int n : {3, 4, 7}) cages.push_back({"pyramid" + std::to_string(n), pyramid(n)});
  cages.push_back({"torus", torus(5, 4)});
  cages.push_back({"needles", torus(4, 40)});
  cages.push_back({"cap40", needle_box(40, 4)});
  for (const float s : {0.1F, 0.5F, 1.0F, 2.3F, 3.7F, 5.0F, 8.2F, 10.0F}) {
    const std::string tag = std::to_string(static_cast<int>(10 * s));
    cages.push_back({"cube_crease" + tag, with_crease(spindle(3), s)});
    cages.push_back({"valence7_crease" + tag, with_crease(spindle(7), s)});
    cages.push_back({"valence2_crease" + tag, with_crease(spindle(2), s)});
    cages.push_back({"prism5_crease" + tag, with_crease(prism(5), s)});
    cages.push_back({"sheet_crease" + tag, with_crease(sheet(4, 3), s), false, false});
  }
  auto corner = spindle(3);
  corner.corners = {{0, 2.5F}, {1, 10.0F}};
  cages.push_back({"corners", corner});
  cages.push_back({"sheet", sheet(4, 3), false, false});
  auto edge_only = sheet(4, 3);
  edge_only.boundary = scene::Boundary::EdgeOnly;
  cages.push_back({"sheet_edge_only", edge_only, false, false});
  auto none = sheet(4, 3);
  none.boundary = scene::Boundary::None;
  cages.push_back({"sheet_none", none, false, false});
  auto holed = prism(5);
  holed.holes = {1};
  cages.push_back({"hole", holed, false, false});
  cages.push_back({"book3", book(3), false, false});
  cages.push_back({"book4", book(4), false, false});
  cages.push_back({"bow_tie", bow_tie()});
  auto flat = torus(5, 4);
  for (std::size_t i = 0; i < 4; ++i) flat.positions[i] = flat.positions[0];
  cages.push_back({"collapsed_ring", flat, true, true});
  return cages;
}

}  // namespace gnomon::test
