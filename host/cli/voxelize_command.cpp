// SPDX-License-Identifier: Apache-2.0
// gnomon voxelize: the voxels of a model's limit surface, for NumPy, Blender and Houdini.
#include <fmt/format.h>

#include "host/cli/command.hpp"
#include "host/cli/output_files.hpp"
#include "host/cli/scene_voxels.hpp"
#include "host/cli/surface_options.hpp"
#include "host/cli/voxel_files.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

class VoxelizeCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("voxelize", "Voxelize the limit surface of a model");
    options_.add_to(*command, "FILE.npy or FILE.vdb, repeatable; FILE.json is written beside it");
    command->add_option("--adjacency", adjacency_, "6, 18 or 26 (the same as --set adjacency=N)")
        ->type_name("N");
    command->footer(
        "Without a ground, unless --set ground=on.\n\nExample:\n  gnomon voxelize cup.obj --res 256 -o "
        "cup.vdb");
    return command;
  }

  Result<int> run(Context& context) override {
    if (Result<void> sound = check_outputs(); !sound) return tl::make_unexpected(sound.error());
    std::vector<std::string> flags;
    if (!adjacency_.empty()) flags.push_back("adjacency=" + adjacency_);
    const Result<LoadedScene> input = options_.load(context, flags);
    if (!input) return tl::make_unexpected(input.error());
    const Result<voxel::CoordinateSet> voxels = voxelize_scene_coordinates(context, *input);
    if (!voxels) return tl::make_unexpected(voxels.error());
    context.interruption.check();
    if (Result<void> written = write(*voxels); !written) return tl::make_unexpected(written.error());
    report(*voxels);
    return kDone;
  }

 private:
  Result<void> check_outputs() const {
    for (const fs::path& output : options_.outputs) {
      if (output.extension() != ".npy" && output.extension() != ".vdb") {
        return fail(fmt::format("-o {}: expected a name that ends in .npy or .vdb", output.string()));
      }
      if (Result<void> possible = check_output(output); !possible) return possible;
    }
    return {};
  }

  Result<void> write(const voxel::CoordinateSet& voxels) const {
    const std::vector<std::array<std::int32_t, 3>> rows = sorted_coordinates(voxels);
    OutputFiles files;
    for (const fs::path& output : options_.outputs) {
      Result<void> added = files.add(output, [&](const fs::path& temporary) {
        return output.extension() == ".npy" ? write_npy(temporary, rows)
                                            : write_vdb(temporary, rows, voxels.grid);
      });
      if (added) {
        added = files.add(fs::path(output).replace_extension(".json"), [&](const fs::path& temporary) {
          return write_bytes(temporary, grid_json(voxels.grid).dump(2) + "\n");
        });
      }
      if (!added) return added;
    }
    return files.commit();
  }

  void report(const voxel::CoordinateSet& voxels) const {
    const voxel::VoxelStatistics& s = voxels.statistics;
    const double count = static_cast<double>(voxels.voxels.size());
    if (options_.json) {
      options_.print_json({{"voxels", voxels.voxels.size()},
                           {"evaluations", s.evaluations},
                           {"subpatches", s.subpatches},
                           {"floor_hits", s.floor_hits},
                           {"seconds", s.seconds},
                           {"grid", grid_json(voxels.grid)}});
      return;
    }
    fmt::print("{} voxels at {}^3, {}-adjacent, {:.2f} evaluations a voxel, {:.3f} s\n", voxels.voxels.size(),
               voxels.grid.res, static_cast<int>(voxels.grid.adjacency),
               static_cast<double>(s.evaluations) / count, s.seconds);
    if (s.floor_hits > 0) fmt::print("{} subpatches reached the recursion floor\n", s.floor_hits);
    options_.print_outputs();
  }

  SurfaceOptions options_;
  std::string adjacency_;
};

}  // namespace

std::unique_ptr<Command> make_voxelize_command() {
  return std::make_unique<VoxelizeCommand>();
}

}  // namespace gnomon::cli
