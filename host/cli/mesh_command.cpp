// SPDX-License-Identifier: Apache-2.0
// gnomon mesh: a model's limit surface as a watertight mesh.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <thread>

#include "host/cli/command.hpp"
#include "host/cli/output_files.hpp"
#include "host/cli/scene_voxels.hpp"
#include "host/cli/surface_options.hpp"
#include "host/mesh/edge_census.hpp"
#include "host/mesh/mesh_files.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

class MeshCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("mesh", "Mesh the limit surface of a model, without cracks");
    options_.add_to(*command, "FILE.obj or FILE.ply, repeatable");
    command->footer(
        "Faces are about as large as a voxel. Without a ground, unless --set ground=on.\n\nExample:\n  "
        "gnomon "
        "mesh cup.obj --res 256 -o cup.ply");
    return command;
  }

  Result<int> run(Context& context) override {
    for (const fs::path& output : options_.outputs) {
      if (const auto format = mesh::mesh_format(output); !format) return tl::make_unexpected(format.error());
      if (Result<void> possible = check_output(output); !possible)
        return tl::make_unexpected(possible.error());
    }
    const Result<LoadedScene> input = options_.load(context);
    if (!input) return tl::make_unexpected(input.error());
    const Result<mesh::SurfaceMesh> made = make_mesh(context, *input);
    if (!made) return tl::make_unexpected(made.error());
    if (Result<void> written = write(context, *made); !written) return tl::make_unexpected(written.error());
    report(*made, input->scene);
    return kDone;
  }

 private:
  static Result<mesh::SurfaceMesh> make_mesh(Context& context, const LoadedScene& input) {
    const auto threads = static_cast<std::size_t>(input.settings.integer("threads"));
    const tbb::global_control limit(
        tbb::global_control::max_allowed_parallelism,
        threads > 0 ? threads : std::max<std::size_t>(1, std::thread::hardware_concurrency()));
    const Result<VoxelizedScene> voxelized = voxelize_with_subpatches(context, input);
    if (!voxelized) return tl::make_unexpected(voxelized.error());
    std::vector<std::string> names;
    for (const scene::Object& object : input.scene.objects) names.push_back(object.name);
    context.interruption.check();
    return mesh::surface_mesh(voxelized->surfaces, voxelized->voxels, names);
  }

  Result<void> write(Context& context, const mesh::SurfaceMesh& made) const {
    OutputFiles files;
    for (const fs::path& output : options_.outputs) {
      Result<void> added = files.add(output, [&](const fs::path& temporary) {
        return mesh::write_mesh(*mesh::mesh_format(output), temporary, made, {},
                                [&] { context.interruption.check(); });
      });
      if (!added) return added;
    }
    return files.commit();
  }

  void report(const mesh::SurfaceMesh& made, const scene::Scene& scene) const {
    const mesh::EdgeCensus census = mesh::edge_census(made.faces);
    const auto quads = static_cast<std::size_t>(std::ranges::count_if(
        made.faces, [](const mesh::Corners& face) { return mesh::corner_count(face) == 4; }));
    const std::size_t triangles = made.faces.size() - quads;
    if (options_.json) {
      options_.print_json({{"objects", scene.objects.size()},
                           {"vertices", made.positions.size()},
                           {"quads", quads},
                           {"triangles", triangles},
                           {"edges", census.edges},
                           {"open_edges", census.open},
                           {"crowded_edges", census.crowded},
                           {"turned_edges", census.turned},
                           {"closed", census.closed()}});
      return;
    }
    fmt::print("{} vertices, {} quads, {} triangles, {} edges: {}\n", made.positions.size(), quads, triangles,
               census.edges,
               census.closed() ? std::string("closed")
                               : fmt::format("{} open, {} with more than two faces, {} turned", census.open,
                                             census.crowded, census.turned));
    options_.print_outputs();
  }

  SurfaceOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_mesh_command() {
  return std::make_unique<MeshCommand>();
}

}  // namespace gnomon::cli
