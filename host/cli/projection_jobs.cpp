// SPDX-License-Identifier: Apache-2.0
// What the hardware is asked to do for a scene.
#include "host/cli/projection_jobs.hpp"

#include "host/cli/scene_voxels.hpp"
#include "host/cli/vpu_settings.hpp"
#include "host/plan/vpu_plan.hpp"

namespace gnomon::cli {

Result<std::vector<ProjectionJob>> projection_jobs(Context& context, const LoadedScene& input) {
  const Result<voxel::VoxelSet> voxels = voxelize_scene(context, input);
  if (!voxels) return tl::make_unexpected(voxels.error());
  std::vector<bool> two_sided;
  for (const scene::Object& object : input.scene.objects) two_sided.push_back(object.two_sided);
  std::vector<ProjectionJob> jobs;
  for (const scene::DirectionalLight& light : input.scene.lights) {
    context.interruption.check();
    // The grid is the world moved and scaled evenly: directions stay.
    const Result<plan::VpuPlan> plan = plan::plan_vpu(*voxels, light.direction, vpu_settings(input.settings));
    if (!plan) return tl::make_unexpected(plan.error());
    jobs.push_back({plan->config,
                    plan::vpu_stream(*plan, *voxels, plan::voxel_items(*voxels, plan->config), two_sided)});
  }
  return jobs;
}

sim::RtlOptions rtl_options(const Context& context, const config::Settings& settings,
                            const std::vector<std::string>& defines) {
  sim::RtlOptions options;
  options.seed = static_cast<std::uint32_t>(settings.integer("seed"));
  options.abort = &context.interruption.flag();
  options.defines = defines;
  return options;
}

void add_define_option(CLI::App& command, std::vector<std::string>& defines) {
  command
      .add_option("--define", defines,
                  "Build the hardware with a preprocessor name set, e.g. a GNOMON_MUTATE_* fault")
      ->type_name("NAME")
      ->allow_extra_args(false);
}

Result<sim::ModelCache> model_cache(const Context& context) {
  const std::shared_ptr<spdlog::logger> log = context.log;
  try {
    return sim::ModelCache(sim::Toolchain::from_environment(),
                           [log](const std::string& notice) { log->info("{}", notice); });
  } catch (const std::exception& error) {
    return fail(error.what());
  }
}

}  // namespace gnomon::cli
