// SPDX-License-Identifier: Apache-2.0
// What is lit, by what, seen from where. Everything is in world coordinates, in double.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/base/light.hpp"
#include "host/base/result.hpp"
#include "host/base/vec.hpp"
#include "host/scene/control_mesh.hpp"
#include "host/scene/mesh_topology.hpp"
#include "host/voxel/voxel_set.hpp"

namespace gnomon::scene {

/// One control cage placed in the world. A transform that mirrors has been made up for in the winding.
struct Object {
  std::string name;
  ControlMesh mesh;        ///< in its own coordinates
  Mat4 to_world;           ///< row vectors: p_world = p * to_world
  Box3 bounds;             ///< of its limit surface, in the world
  bool ground = false;     ///< the receiver that was put under the models
  bool two_sided = false;  ///< an open surface: it has no inside, both of its sides can be lit
  bool casts = true;       ///< throws shadows, on itself too
  bool receives = true;    ///< shadows fall on it; else it is lit wherever it faces a light that reaches it
  MeshStatistics statistics;
};

struct Camera {
  Vec3 eye, target, up;
  double fov = 30;  ///< vertical opening angle, degrees
};

struct Scene {
  std::string name;
  std::filesystem::path source;  ///< the file that was loaded, as given
  std::vector<Object> objects;   ///< at least one; the ground, if any, is the last
  std::vector<Light> lights;     ///< at least one
  Camera camera;
  std::vector<std::string> warnings;  ///< what was ignored or repaired, one line each
};

/// Which way is up in a file that does not say.
enum class UpAxis : std::uint8_t { Y, Z };

/// How a model's faces are to be understood.
enum class SurfaceKind : std::uint8_t {
  CatmullClark,  ///< the control cage of a smooth limit surface
  Polygons,      ///< the surface itself: every edge and vertex is infinitely sharp
};

/// What applies where the file itself does not say: a bare OBJ says none of it.
struct SceneOptions {
  bool ground = true;
  std::optional<Vec3> light;  ///< the way the light travels; replaces a scene file's lights. Where neither
                              ///< says: from the upper left, in front
  UpAxis up = UpAxis::Y;
  SurfaceKind surface = SurfaceKind::CatmullClark;
  double image_aspect = 4.0 / 3.0;  ///< width by height, for a camera that fits
};

/// Loads a bare OBJ, which gets a ground, a light and a camera that fit it, or a scene file (.json, .toml;
/// docs/models.md). Errors are one line naming file, line or key.
Result<Scene> load_scene(const std::filesystem::path& path, const SceneOptions& options = {});

/// The grid that holds all objects with a margin of at least one voxel; the longest side of their box fills
/// it. Along every axis the box begins at a voxel's centre, so that a ground plane does not run along voxel
/// walls.
Result<voxel::Grid> fit_grid(const Scene& scene, std::uint32_t res, voxel::Adjacency adjacency);

/// From the object's own coordinates to the grid's, where one unit is one voxel.
Mat4 to_grid(const Object& object, const voxel::Grid& grid);
/// From world coordinates to the grid's.
Mat4 to_grid(const voxel::Grid& grid);

}  // namespace gnomon::scene
