// SPDX-License-Identifier: Apache-2.0
// What the hardware is asked to do for a scene: one command stream for each technique and light.
#pragma once

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/config.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/cli/scene_input.hpp"
#include "sim/model_cache.hpp"
#include "sim/rtl_engine.hpp"

namespace gnomon::cli {

struct ShadowJob {
  std::string name;  ///< "light 2, slb"; empty where there is one light and one technique
  golden::HardwareConfig config;
  std::vector<golden::Word> stream;
};

/// Voxelizes the scene and makes every technique's stream for every light, all its views in one stream: a
/// silhouette-line buffer is asked about every voxel. Lights that reach nothing have none. Throws
/// Interrupted.
Result<std::vector<ShadowJob>> shadow_jobs(Context& context, const LoadedScene& input);

/// Options of the rtl engine that several subcommands share: seed, Ctrl-C, and faults to be built in.
sim::RtlOptions rtl_options(const Context& context, const config::Settings& settings,
                            const std::vector<std::string>& defines);

/// "--engine rtl|system": the engine that is compared with golden.
void add_engine_option(CLI::App& command, std::string& engine);

/// The engine of that name. Throws as sim::make_rtl_engine.
std::unique_ptr<sim::RtlEngine> engine_under_test(const std::string& engine, const config::Settings& settings,
                                                  const golden::HardwareConfig& config,
                                                  const sim::RtlOptions& options, sim::ModelCache& cache);

/// "--define NAME": builds the hardware with a preprocessor name set.
void add_define_option(CLI::App& command, std::vector<std::string>& defines);

/// A cache of compiled models that says in the log when it compiles one. Fails where it has no folder, or
/// tools are missing.
Result<sim::ModelCache> model_cache(const Context& context);

/// Calls `work` with a cache of compiled models; what the user can cure (no compiler, an interruption)
/// becomes an Error or Interrupted.
template <class Work>
auto with_models(const Context& context, Work&& work)
    -> Result<decltype(work(std::declval<sim::ModelCache&>()))> {
  Result<sim::ModelCache> cache = model_cache(context);
  if (!cache) return tl::make_unexpected(cache.error());
  try {
    return work(*cache);
  } catch (const sim::Aborted&) {
    throw Interrupted();
  } catch (const sim::ModelBuildError& error) {
    return fail(error.what());
  }
}

}  // namespace gnomon::cli
