// SPDX-License-Identifier: Apache-2.0
// Control cages of our own making, for the tests of surfaces and voxels.
#pragma once

#include <vector>

#include "host/scene/control_mesh.hpp"

namespace gnomon::test {

/// Two poles of valence `n` and a zigzag ring of 2n vertices of valence 3: 2n quads, closed. n = 2 has
/// vertices of valence 2, n = 3 is a cube.
scene::ControlMesh spindle(int n, double radius = 1);
/// A prism over a regular n-gon: two n-gons and n quads, closed.
scene::ControlMesh prism(int n);
/// A pyramid: n triangles and an n-gon, closed.
scene::ControlMesh pyramid(int n);
/// A ring of m by n quads around a hole, closed and regular.
scene::ControlMesh torus(int m, int n, double thickness = 0.4);
/// nx by ny quads in a wavy sheet, open; `length` is its extent along x, 1 along y.
scene::ControlMesh sheet(int nx, int ny, double length = 1);
/// A closed box of needles: the sides are `n` quads each, as long as the box.
scene::ControlMesh needle_box(int n, double length);
/// `n` quads around one edge: non-manifold from 3 on.
scene::ControlMesh book(int n);
/// Two spindles that share one vertex.
scene::ControlMesh bow_tie();

/// Tags every edge of the face with this sharpness.
void crease_face(scene::ControlMesh& mesh, std::size_t face, float sharpness);

/// The same cage with its faces in another order, each starting at another of its vertices.
scene::ControlMesh shuffled(const scene::ControlMesh& mesh, unsigned seed);

/// From the cage's own box to [margin, res - margin]^3, keeping proportions.
Mat4 fit_to_grid(const std::vector<scene::ControlMesh>& meshes, double res, double margin = 2);

}  // namespace gnomon::test
