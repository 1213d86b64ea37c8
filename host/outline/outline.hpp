// SPDX-License-Identifier: Apache-2.0
// Silhouettes as a directional light sees them: closed oriented loops in a plane's pixels. Theory:
// docs/outline.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/scene/control_mesh.hpp"
#include "host/surface/limit_surface.hpp"

namespace gnomon::outline {

/// The light's view as an affine map of the surface's coordinates (the grid's): plane pixels to the right and
/// up, and depth codes that grow away from the light.
struct LightFrame {
  Vec3 x, y, depth;  ///< pixels, pixels and depth codes per unit of each coordinate
  double x1 = 0, y1 = 0, depth1 = 0;
  Vec2 pixel(const Vec3& p) const { return {x.dot(p) + x1, y.dot(p) + y1}; }
  double code(const Vec3& p) const { return depth.dot(p) + depth1; }
};

/// A corner of a loop. Nothing is rounded yet.
struct Vertex {
  double x, y;   ///< plane pixels, y up
  double depth;  ///< depth codes
};

/// Closed: the last vertex joins the first. What casts the shadow is on the left.
using Loop = std::vector<Vertex>;

struct Statistics {
  std::size_t faces = 0;               ///< parametric faces, or triangles of polygons
  std::size_t contour_faces = 0;       ///< with the contour inside
  std::size_t cells = 0;               ///< rectangles of parameter space that were looked at
  std::size_t open_parts = 0;          ///< connected parts that are no closed surface
  std::size_t doubled_parts = 0;       ///< open parts of which both sides are sent
  std::size_t boundary_edges = 0;      ///< of one face (edges of the cage, middles of n-gons' edges divide)
  std::size_t non_manifold_edges = 0;  ///< of three faces or more, or of two that disagree about the winding
  std::size_t contour_vertices = 0;    ///< points found where N.L = 0, before thinning
  std::size_t border_vertices = 0;     ///< points of boundaries and creases, before thinning
  std::size_t vertices = 0;            ///< of the loops, after thinning
  std::size_t dropped_loops = 0;       ///< collapsed to a point or to a line there and back
};

/// One object's silhouettes. The winding number of all its loops at a point of the plane is the number of
/// its sheets there that face the light; for open parts it may be the number of those that do not, or of all
/// (docs/outline.md, "Which chain of edges"). It is at least 1 exactly in the shadow of that object, up to
/// the error stated there.
struct ObjectOutline {
  std::uint32_t object = 0;  ///< index of the surface
  std::vector<Loop> loops;
  Statistics statistics;
};

struct Options {
  int frac_bits = 7;      ///< F: edges are so short that they leave the curve by at most 2^-F / 4 pixels
  double min_edge = 0.3;  ///< pixels; curves are not followed with shorter edges, however tight
  double max_edge = 4;    ///< pixels; edges are not longer, however straight
  /// Where the curve is tighter than that, one vertex for each of its stays in a pixel; and edges in the
  /// middle of what they stand for. Otherwise every vertex lies on the curve itself.
  bool fit_pixels = true;
  unsigned threads = 0;  ///< 0: all cores; no result depends on it
};

/// Outlines of limit surfaces, in the order given. Every contour and boundary is sent, hidden ones too.
/// Errors: a frame that is not finite or maps onto less than the plane and depth; options out of range
/// (frac_bits 1..16, 0 < min_edge <= max_edge).
Result<std::vector<ObjectOutline>> outlines(std::span<const surface::LimitSurface> surfaces,
                                            const LightFrame& frame, const Options& options = {});

/// The same for polygon meshes that are drawn as they are (faces are cut into triangles by their ears;
/// creases do not matter, holes are left out). `frame` applies to the meshes' positions. Edges are sent
/// whole.
Result<std::vector<ObjectOutline>> outlines_of_polygons(std::span<const scene::ControlMesh> meshes,
                                                        const LightFrame& frame);

}  // namespace gnomon::outline
