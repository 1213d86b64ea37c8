// SPDX-License-Identifier: Apache-2.0
// A run's surfaces and shadows as meshes.
#include "host/pipeline/scene_meshes.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "host/mesh/mesh_files.hpp"
#include "host/mesh/surface_mesh.hpp"

namespace gnomon::pipeline {
namespace {

std::vector<mesh::VertexShadows> shadows_of(const TechniqueJob& job, const mesh::SurfaceMesh& mesh) {
  std::vector<mesh::VertexShadows> lights;
  for (const auto& states : job.states()) lights.push_back(mesh::vertex_shadows(mesh, states));
  return lights;
}

}  // namespace

Result<void> write_meshes(const report::OutputDirectory& output, const RunRequest& request,
                          const LitScene& scene, std::span<const std::unique_ptr<TechniqueJob>> jobs,
                          Stages& stages) {
  if (request.meshes.empty()) return {};
  return stages.run("meshes", [&]() -> Result<void> {
    std::vector<std::string> names;
    for (const scene::Object& object : request.scene.objects) names.push_back(object.name);
    const mesh::SurfaceMesh made = mesh::surface_mesh(scene.surfaces, scene.voxels, names);
    const auto poll = [&] { stages.progress("meshes", 0); };
    const auto asked = [&](mesh::MeshFormat format) {
      return std::ranges::count(request.meshes, format) > 0;
    };
    if (asked(mesh::MeshFormat::Obj)) {
      if (auto done = mesh::write_obj(output.staging() / "mesh.obj", made, poll); !done)
        return fail("mesh.obj: cannot be written: " + done.error().message);
    }
    if (!asked(mesh::MeshFormat::Ply)) return {};
    for (const auto& job : jobs) {
      const std::string name = "mesh" + (job == jobs.front() ? "" : "-" + job->name()) + ".ply";
      if (auto done = mesh::write_ply(output.staging() / name, made, shadows_of(*job, made), poll); !done)
        return fail(name + ": cannot be written: " + done.error().message);
    }
    return {};
  });
}

}  // namespace gnomon::pipeline
