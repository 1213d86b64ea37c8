// SPDX-License-Identifier: Apache-2.0
// Scene files: models with transforms, lights, a camera and parameters, in TOML or JSON. Format:
// docs/models.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/config/settings.hpp"
#include "host/scene/scene.hpp"

namespace gnomon::scene {

/// A scene file as written; models are not read yet.
struct SceneFile {
  struct Model {
    std::filesystem::path path;  ///< relative to the working directory (or absolute)
    std::string name;            ///< empty: the objects' own names
    Mat4 transform;
    bool rest = false;     ///< then moved along up until its lowest point is at 0
    bool casts = true;     ///< as Object::casts, for all objects of the model
    bool receives = true;  ///< as Object::receives
  };
  std::string name;
  std::vector<Model> models;  ///< at least one
  std::vector<Light> lights;  ///< may be empty
  std::optional<Camera> camera;
  std::vector<config::Assignment> parameters;
};

/// True for .json and .toml; everything else is an OBJ.
bool is_scene_file(const std::filesystem::path& path);

/// Errors are one line, "path:line: error: ..."; unknown keys name the nearest known one.
Result<SceneFile> read_scene_file(const std::filesystem::path& path);

/// The parameters that a scene file sets; none for an OBJ.
Result<std::vector<config::Assignment>> scene_parameters(const std::filesystem::path& path);

}  // namespace gnomon::scene
