// SPDX-License-Identifier: Apache-2.0
// Scene files in TOML or JSON.
#include "host/scene/scene_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "host/scene/entries.hpp"
#include "host/scene/scene_lights.hpp"

namespace gnomon::scene {
namespace {

using config::Document;

/// "matrix": four rows of the column-vector convention, p' = M p, as textbooks print them.
Result<Mat4> read_matrix(const Document& document, const Pointer& at) {
  const nlohmann::json& rows = document.root().at(at);
  const std::string shape = key_of(at) + " is not a list of four rows of four numbers";
  if (!rows.is_array() || rows.size() != 4) return document.refuse(at, shape);
  Mat4 matrix;
  for (unsigned r = 0; r < 4; ++r) {
    if (!rows[r].is_array() || rows[r].size() != 4) return document.refuse(at, shape);
    for (unsigned c = 0; c < 4; ++c) {
      const Result<double> value = read_number(document, at / r / c);
      if (!value) return tl::make_unexpected(value.error());
      matrix[static_cast<int>(c)][static_cast<int>(r)] = *value;
    }
  }
  if (matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1) {
    return document.refuse(at, key_of(at) + " is not affine: its last row must be 0 0 0 1");
  }
  return matrix;
}

Result<Vec3> read_scale(const Document& document, const Pointer& at) {
  if (document.root().at(at).is_array()) return read_vector(document, at);
  return read_number(document, at).map([](double s) { return Vec3(s, s, s); });
}

/// scale, then rotate (degrees about x, then y, then z), then translate.
Result<Mat4> read_transform(const Document& document, const Pointer& model) {
  if (has(document, model, "matrix")) {
    for (const char* other : {"translate", "rotate", "scale"}) {
      if (has(document, model, other)) {
        return document.refuse(model / other, fmt::format("{} next to matrix, expected one or the other",
                                                          key_of(model / other)));
      }
    }
    return read_matrix(document, model / "matrix");
  }
  Mat4 scale, rotate, translate;
  if (has(document, model, "scale")) {
    const Result<Vec3> factors = read_scale(document, model / "scale");
    if (!factors) return tl::make_unexpected(factors.error());
    scale.setScale(*factors);
  }
  if (has(document, model, "rotate")) {
    const Result<Vec3> degrees = read_vector(document, model / "rotate");
    if (!degrees) return tl::make_unexpected(degrees.error());
    rotate.setEulerAngles(*degrees * (std::numbers::pi / 180));
  }
  if (has(document, model, "translate")) {
    const Result<Vec3> offset = read_vector(document, model / "translate");
    if (!offset) return tl::make_unexpected(offset.error());
    translate.setTranslation(*offset);
  }
  return scale * rotate * translate;
}

Result<SceneFile::Model> read_model(const Document& document, const Pointer& at) {
  if (Result<void> table = expect(document, at, &nlohmann::json::is_object, "a table"); !table) {
    return tl::make_unexpected(table.error());
  }
  if (Result<void> known = document.check_keys(
          at, {"path", "name", "translate", "rotate", "scale", "matrix", "rest", "casts", "receives"});
      !known) {
    return tl::make_unexpected(known.error());
  }
  if (!has(document, at, "path"))
    return document.refuse(at, key_of(at) + " has no path, expected the name of an OBJ file");
  const Result<std::string> path = read_text(document, at / "path");
  if (!path) return tl::make_unexpected(path.error());
  SceneFile::Model model;
  model.path = document.path().parent_path() / *path;
  if (has(document, at, "name")) {
    Result<std::string> name = read_text(document, at / "name");
    if (!name) return tl::make_unexpected(name.error());
    model.name = std::move(*name);
  }
  for (const auto& [key, member] : {std::pair{"rest", &SceneFile::Model::rest},
                                    {"casts", &SceneFile::Model::casts},
                                    {"receives", &SceneFile::Model::receives}}) {
    if (!has(document, at, key)) continue;
    const Result<bool> flag = read_flag(document, at / key);
    if (!flag) return tl::make_unexpected(flag.error());
    model.*member = *flag;
  }
  const Result<Mat4> transform = read_transform(document, at);
  if (!transform) return tl::make_unexpected(transform.error());
  model.transform = *transform;
  const double scale = std::abs(model.transform.determinant());
  if (!(scale > 0) || !std::isfinite(scale))
    return document.refuse(at, key_of(at) + " is flattened by its transform: the scale is zero");
  return model;
}

Result<Camera> read_camera(const Document& document, const Pointer& at) {
  if (Result<void> table = expect(document, at, &nlohmann::json::is_object, "a table"); !table) {
    return tl::make_unexpected(table.error());
  }
  if (Result<void> known = document.check_keys(at, {"eye", "target", "up", "fov"}); !known) {
    return tl::make_unexpected(known.error());
  }
  Camera camera;
  camera.up = {0, 1, 0};
  for (const auto& [key, member] :
       {std::pair{"eye", &Camera::eye}, {"target", &Camera::target}, {"up", &Camera::up}}) {
    if (!has(document, at, key)) {
      if (member == &Camera::up) continue;
      return document.refuse(at, fmt::format("camera has no {}", key));
    }
    const Result<Vec3> vector = read_vector(document, at / key);
    if (!vector) return tl::make_unexpected(vector.error());
    camera.*member = *vector;
  }
  if (has(document, at, "fov")) {
    const Result<double> fov = read_number(document, at / "fov");
    if (!fov) return tl::make_unexpected(fov.error());
    camera.fov = *fov;
    if (camera.fov < 1 || camera.fov > 170)
      return document.refuse(at / "fov",
                             fmt::format("camera/fov = {} is out of range 1..170 degrees", camera.fov));
  }
  if (!((camera.eye - camera.target).cross(camera.up).length() > 0)) {
    return document.refuse(at, "camera looks along its up direction, or nowhere: eye and target must differ");
  }
  return camera;
}

Result<config::Assignment> read_parameter(const Document& document, const Pointer& at,
                                          const std::string& key) {
  const nlohmann::json& value = document.root().at(at);
  config::Assignment assignment{key, "", document.place(at)};
  if (value.is_boolean()) {
    assignment.text = value.get<bool>() ? "on" : "off";
  } else if (value.is_string()) {
    assignment.text = value.get<std::string>();
  } else if (value.is_array()) {
    for (const nlohmann::json& item : value)
      assignment.text += (assignment.text.empty() ? "" : ",") + item.dump();
  } else if (value.is_number()) {
    assignment.text = value.dump();
  } else {
    return document.refuse(at, fmt::format("{} is not a value", key_of(at)));
  }
  return assignment;
}

/// Reads every entry of the list at `key` with `read` into `to`; an absent list is empty.
template <class T, class Read>
Result<void> read_list(const Document& document, const char* key, std::vector<T>& to, Read read) {
  const Pointer at = Pointer() / key;
  if (!has(document, Pointer(), key)) return {};
  if (Result<void> list = expect(document, at, &nlohmann::json::is_array, "a list of tables"); !list)
    return list;
  for (std::size_t i = 0; i < document.root().at(at).size(); ++i) {
    Result<T> item = read(document, at / i);
    if (!item) return tl::make_unexpected(item.error());
    to.push_back(std::move(*item));
  }
  return {};
}

Result<void> read_parameters(const Document& document, std::vector<config::Assignment>& to) {
  const Pointer at = Pointer() / "parameters";
  if (!has(document, Pointer(), "parameters")) return {};
  if (Result<void> table = expect(document, at, &nlohmann::json::is_object, "a table"); !table) return table;
  for (const auto& [key, value] : document.root().at(at).items()) {
    Result<config::Assignment> assignment = read_parameter(document, at / key, key);
    if (!assignment) return tl::make_unexpected(assignment.error());
    to.push_back(std::move(*assignment));
  }
  return {};
}

}  // namespace

bool is_scene_file(const std::filesystem::path& path) {
  return path.extension() == ".json" || path.extension() == ".toml";
}

Result<SceneFile> read_scene_file(const std::filesystem::path& path) {
  const Result<Document> document = Document::read(path);
  if (!document) return tl::make_unexpected(document.error());
  SceneFile file;
  const auto read_all = [&]() -> Result<void> {
    Result<void> done = document->check_keys(Pointer(), {"name", "models", "lights", "camera", "parameters"});
    if (done) done = read_list(*document, "models", file.models, read_model);
    if (done) done = read_list(*document, "lights", file.lights, read_light);
    if (done) done = read_parameters(*document, file.parameters);
    return done;
  };
  if (Result<void> done = read_all(); !done) return tl::make_unexpected(done.error());
  if (file.models.empty())
    return document->refuse(Pointer(), "no models found, expected [[models]] with a path");
  file.name = path.stem().string();
  if (has(*document, Pointer(), "name")) {
    Result<std::string> name = read_text(*document, Pointer() / "name");
    if (!name) return tl::make_unexpected(name.error());
    file.name = std::move(*name);
  }
  if (has(*document, Pointer(), "camera")) {
    const Result<Camera> camera = read_camera(*document, Pointer() / "camera");
    if (!camera) return tl::make_unexpected(camera.error());
    file.camera = *camera;
  }
  return file;
}

Result<std::vector<config::Assignment>> scene_parameters(const std::filesystem::path& path) {
  if (!is_scene_file(path)) return std::vector<config::Assignment>{};
  return read_scene_file(path).map([](SceneFile&& file) { return std::move(file.parameters); });
}

}  // namespace gnomon::scene
