// SPDX-License-Identifier: Apache-2.0
// What the hardware is asked to do for a scene.
#include "host/cli/shadow_jobs.hpp"

#include "host/cli/run_settings.hpp"
#include "host/cli/scene_voxels.hpp"
#include "host/pipeline/technique.hpp"

namespace gnomon::cli {

Result<std::vector<ShadowJob>> shadow_jobs(Context& context, const LoadedScene& input) {
  const Result<VoxelizedScene> voxelized = voxelize_with_subpatches(context, input);
  if (!voxelized) return tl::make_unexpected(voxelized.error());
  std::vector<bool> two_sided;
  for (const scene::Object& object : input.scene.objects) two_sided.push_back(object.two_sided);
  const pipeline::RunSettings settings = run_settings(input.settings);
  std::vector<ShadowJob> jobs;
  for (const Light& any : input.scene.lights) {
    const auto* light = std::get_if<DirectionalLight>(&any);
    if (light == nullptr)
      return fail(input.scene.source.string() +
                  ": has a light that is not directional, expected directional ones");
    context.interruption.check();
    // The grid is the world moved and scaled evenly: directions stay.
    const Result<std::unique_ptr<pipeline::Technique>> technique = pipeline::make_technique(
        settings, {voxelized->surfaces, two_sided, voxelized->voxels, light->direction});
    if (!technique) return tl::make_unexpected(technique.error());
    Result<std::vector<golden::Word>> stream = (*technique)->stream({});
    if (!stream) return tl::make_unexpected(stream.error());
    jobs.push_back({(*technique)->config(), std::move(*stream)});
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
