// SPDX-License-Identifier: Apache-2.0
// What the hardware is asked to do for a scene.
#include "host/cli/shadow_jobs.hpp"

#include <fmt/format.h>

#include "host/cli/run_settings.hpp"
#include "host/cli/scene_voxels.hpp"
#include "host/cli/system_settings.hpp"
#include "host/pipeline/technique.hpp"

namespace gnomon::cli {

namespace {

/// A light's views, and what the techniques need for each.
struct Views {
  std::vector<plan::LightView> views;
  std::vector<plan::ViewVoxels> seen;
  std::vector<pipeline::TechniqueInput> inputs;
};

Views views_of(const Light& light, const VoxelizedScene& scene, const plan::ObjectRoles& roles,
               pipeline::SceneQuads& quads) {
  Views all;
  for (plan::LightView& view : plan::light_views(light, scene.voxels)) {
    plan::ViewVoxels seen = plan::view_voxels(view, scene.voxels, roles);
    if (seen.receivers.empty()) continue;
    all.views.push_back(std::move(view));
    all.seen.push_back(std::move(seen));
  }
  for (std::size_t i = 0; i < all.views.size(); ++i)
    all.inputs.push_back({scene.surfaces, roles, scene.voxels, quads, all.views[i], all.seen[i]});
  return all;
}

Result<ShadowJob> shadow_job(const std::string& technique, const pipeline::RunSettings& settings,
                             const Views& views) {
  auto techniques = pipeline::make_techniques(technique, settings, views.inputs);
  if (!techniques) return tl::make_unexpected(techniques.error());
  ShadowJob job;
  job.config = techniques->front()->config();
  for (const auto& view : *techniques) job.config = pipeline::joined_hardware(job.config, view->config());
  golden::StreamWriter writer(job.config);
  for (std::uint32_t tag = 0; tag < techniques->size(); ++tag) {
    if (auto done = (*techniques)[tag]->write(writer, job.config, {}); !done)
      return tl::make_unexpected(done.error());
    writer.fence(tag, true);
  }
  job.stream = writer.take();
  return job;
}

}  // namespace

Result<std::vector<ShadowJob>> shadow_jobs(Context& context, const LoadedScene& input) {
  const pipeline::RunSettings settings = run_settings(input.settings);
  if (auto known = pipeline::check_lights(input.scene, settings.techniques); !known)
    return tl::make_unexpected(known.error());
  const Result<VoxelizedScene> voxelized = voxelize_with_subpatches(context, input);
  if (!voxelized) return tl::make_unexpected(voxelized.error());
  plan::ObjectRoles roles;
  for (const scene::Object& object : input.scene.objects) {
    roles.two_sided.push_back(object.two_sided);
    roles.casts.push_back(object.casts);
    roles.receives.push_back(object.receives);
  }
  pipeline::SceneQuads quads(voxelized->surfaces, voxelized->voxels, roles);
  const Mat4 to_grid = scene::to_grid(voxelized->voxels.grid);
  std::vector<ShadowJob> jobs;
  for (std::size_t i = 0; i < input.scene.lights.size(); ++i) {
    context.interruption.check();
    const Views views = views_of(transformed(input.scene.lights[i], to_grid), *voxelized, roles, quads);
    if (views.inputs.empty()) continue;
    for (const std::string& technique : settings.techniques) {
      Result<ShadowJob> job = shadow_job(technique, settings, views);
      if (!job) return tl::make_unexpected(job.error());
      if (input.scene.lights.size() > 1) job->name = fmt::format("light {}", i + 1);
      if (settings.techniques.size() > 1) job->name += (job->name.empty() ? "" : ", ") + technique;
      jobs.push_back(std::move(*job));
    }
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

void add_engine_option(CLI::App& command, std::string& engine) {
  command
      .add_option("--engine", engine,
                  "rtl: the hardware alone; system: within a system of processor, firmware, bus and DRAM")
      ->check(CLI::IsMember({"rtl", "system"}))
      ->capture_default_str();
}

std::unique_ptr<sim::RtlEngine> engine_under_test(const std::string& engine, const config::Settings& settings,
                                                  const golden::HardwareConfig& config,
                                                  const sim::RtlOptions& options, sim::ModelCache& cache) {
  if (engine == "rtl") return sim::make_rtl_engine(config, options, cache);
  sim::system::SystemOptions system = system_settings(settings);
  system.rtl = options;
  return sim::system::make_system_engine(config, system, cache);
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
