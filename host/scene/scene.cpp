// SPDX-License-Identifier: Apache-2.0
// Putting a scene together from its files.
#include "host/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "host/scene/limit_bounds.hpp"
#include "host/scene/obj_reader.hpp"
#include "host/scene/placement.hpp"
#include "host/scene/scene_file.hpp"

namespace gnomon::scene {
namespace {

/// Makes every edge and vertex infinitely sharp: the limit surface is then the polygons themselves.
void sharpen(ControlMesh& mesh) {
  constexpr float kInfinitelySharp = 10;
  mesh.creases.clear();
  mesh.corners.clear();
  std::size_t first = 0;
  for (const std::int32_t face_size : mesh.face_sizes) {
    const auto size = static_cast<std::size_t>(face_size);
    for (std::size_t i = 0; i < size; ++i) {
      mesh.creases.push_back(
          {mesh.face_indices[first + i], mesh.face_indices[first + (i + 1) % size], kInfinitelySharp});
    }
    first += size;
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    mesh.corners.push_back({static_cast<std::int32_t>(v), kInfinitelySharp});
  }
}

/// A bare OBJ is the scene file that names it and nothing else.
Result<SceneFile> describe(const std::filesystem::path& path) {
  if (is_scene_file(path)) return read_scene_file(path);
  SceneFile file;
  file.name = path.stem().string();
  file.models.push_back({path, "", Mat4()});
  return file;
}

/// Moves `objects` together along `up` until their lowest point is at 0.
void put_to_rest(std::span<Object> objects, UpAxis up) {
  const Vec3 direction = up_direction(up);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Object& object : objects) lowest = std::min(lowest, object.bounds.min.dot(direction));
  Mat4 move;
  move.setTranslation(direction * -lowest);
  for (Object& object : objects) {
    object.to_world = object.to_world * move;
    object.bounds = Box3(object.bounds.min * move, object.bounds.max * move);
  }
}

Result<void> add_model(Scene& scene, const SceneFile::Model& model, const SceneOptions& options) {
  Result<ObjModel> obj = read_obj(model.path);
  if (!obj) return tl::make_unexpected(obj.error());
  for (const std::string& warning : obj->warnings)
    scene.warnings.push_back(model.path.string() + ": " + warning);
  const std::size_t before = scene.objects.size();
  for (std::size_t i = 0; i < obj->meshes.size(); ++i) {
    Object object;
    object.mesh = std::move(obj->meshes[i]);
    object.statistics = obj->statistics[i];
    object.name = object.mesh.name;
    if (!model.name.empty())
      object.name = obj->meshes.size() == 1 ? model.name : model.name + "/" + object.mesh.name;
    object.to_world = model.transform;
    object.two_sided = !is_closed(object.statistics);
    object.casts = model.casts;
    object.receives = model.receives;
    if (options.surface == SurfaceKind::Polygons) sharpen(object.mesh);
    if (model.transform.determinant() < 0) reverse_winding(object.mesh);
    const Result<Box3> bounds = limit_bounds(object.mesh, object.to_world);
    if (!bounds)
      return fail(fmt::format("{}: error: object '{}': {}", model.path.string(), object.name,
                              bounds.error().message));
    object.bounds = *bounds;
    scene.objects.push_back(std::move(object));
  }
  if (model.rest) put_to_rest(std::span(scene.objects).subspan(before), options.up);
  return {};
}

Box3 bounds_of(const std::vector<Object>& objects) {
  Box3 all;
  for (const Object& object : objects) all.extendBy(object.bounds);
  return all;
}

/// A lamp very far away would leave nothing of single precision for the differences between its rays.
Result<void> check_distances(const Scene& scene) {
  constexpr double kFarthest = 10000;
  const Box3 box = bounds_of(scene.objects);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    Vec3 position = box.center();
    if (const auto* spot = std::get_if<SpotLight>(&scene.lights[i])) position = spot->position;
    if (const auto* point = std::get_if<PointLight>(&scene.lights[i])) position = point->position;
    if ((position - box.center()).length() > kFarthest * box.size().length()) {
      return fail(
          fmt::format("{}: error: lights/{} is more than {} times the models' size away, expected a "
                      "nearer or a directional light",
                      scene.source.string(), i, kFarthest));
    }
  }
  return {};
}

}  // namespace

Result<Scene> load_scene(const std::filesystem::path& path, const SceneOptions& options) {
  const Result<SceneFile> file = describe(path);
  if (!file) return tl::make_unexpected(file.error());
  Scene scene;
  scene.name = file->name;
  scene.source = path;
  for (const SceneFile::Model& model : file->models) {
    if (Result<void> added = add_model(scene, model, options); !added)
      return tl::make_unexpected(added.error());
  }
  scene.lights = file->lights;
  if (scene.lights.empty()) scene.lights = {default_light(options.up)};
  if (options.light) scene.lights = {DirectionalLight{options.light->normalized()}};
  if (Result<void> near = check_distances(scene); !near) return tl::make_unexpected(near.error());

  const Box3 models = bounds_of(scene.objects);
  if (options.ground) {
    std::vector<Box3> boxes;
    for (const Object& object : scene.objects) boxes.push_back(object.bounds);
    scene.objects.push_back(make_ground(boxes, options.up, scene.lights));
  }
  if (std::ranges::none_of(scene.objects, &Object::receives))
    return fail(path.string() +
                ": error: no object receives shadows, expected ground = \"on\" or a model that does");
  scene.camera =
      file->camera.value_or(fit_camera(models, bounds_of(scene.objects), options.up, options.image_aspect));
  return scene;
}

}  // namespace gnomon::scene
