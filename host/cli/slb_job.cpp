// SPDX-License-Identifier: Apache-2.0
// What `gnomon slb` works on.
#include "host/cli/slb_job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/progress.hpp"
#include "host/cli/scene_input.hpp"
#include "host/cli/shadow_jobs.hpp"
#include "host/cli/slb_settings.hpp"
#include "host/slb/loop_check.hpp"
#include "host/slb/loop_file.hpp"
#include "host/slb/query_file.hpp"

namespace gnomon::cli {
namespace {

constexpr int kSmallestPlaneLog2 = 4, kLargestPlaneLog2 = 12;

/// The smallest plane that holds every vertex.
int plane_that_holds(const slb::LoopScene& scene) {
  double most = 0;
  for (const slb::FlatCaster& caster : scene) {
    for (const slb::Loop& loop : caster.loops) {
      for (const Vec2& vertex : loop) most = std::max({most, vertex.x, vertex.y});
    }
  }
  int log2 = kSmallestPlaneLog2;
  while (log2 < kLargestPlaneLog2 && most > (1 << log2)) ++log2;
  return log2;
}

Result<golden::HardwareConfig> hardware(const config::Settings& settings, const slb::LoopScene& scene) {
  const plan::SlbSettings chosen = slb_settings(settings);
  golden::HardwareConfig config =
      chosen.hardware(chosen.plane_log2 > 0 ? chosen.plane_log2 : plane_that_holds(scene));
  config.plane_log2 = 4;  // the projection unit does nothing here: its plane need not be cleared for long
  if (const std::optional<std::string> refusal = config.check()) {
    return fail(fmt::format("command line: error: no hardware has these parameters ({}): {}",
                            slb_configuration(config), *refusal));
  }
  return config;
}

}  // namespace

Result<SlbJob> slb_job(const Context& context, const std::filesystem::path& loops,
                       const std::filesystem::path& queries, const std::vector<std::string>& set_flags) {
  Result<config::Settings> settings = load_settings(set_flags);
  if (!settings) return tl::make_unexpected(settings.error());
  Result<slb::LoopFile> file = slb::read_loops(loops);
  if (!file) return tl::make_unexpected(file.error());
  const Result<golden::HardwareConfig> config = hardware(*settings, file->scene);
  if (!config) return tl::make_unexpected(config.error());
  Result<std::vector<slb::FixedCaster>> casters = slb::to_fixed(file->scene, config->slb_config());
  if (!casters) return fail(fmt::format("{}: error: {}", loops.string(), casters.error().message));
  Result<slb::QueryFile> points = queries.empty() ? slb::QueryFile{} : slb::read_queries(queries);
  if (!points) return tl::make_unexpected(points.error());
  // Only now: whoever gets an error gets one line.
  for (const std::string& note : file->notes) context.log->warn("{}", note);
  for (const std::string& line : slb::loops_that_cast_nothing(file->scene, config->slb_config().side()))
    context.log->warn("{}: {}", loops.string(), line);
  if (points->has_header) context.log->info("{}: the first line is a header, not a query", queries.string());
  return SlbJob{loops,
                std::move(*settings),
                *config,
                std::move(file->scene),
                std::move(*casters),
                std::move(points->receivers)};
}

std::string slb_configuration(const golden::HardwareConfig& config) {
  const golden::slb::SlbConfig slb = config.slb_config();
  return fmt::format(
      "plane={} frac_bits={} slope_bits={} frags={} depth_bits={} subpixel_bits={} query_bits={} rounding={}",
      slb.side(), slb.frac_bits, slb.slope_bits, slb.frags, slb.depth_bits, slb.subpixel_bits, slb.query_bits,
      slb.rounding == golden::slb::Rounding::Published ? "published" : "better");
}

slb::Runner slb_runner(Context& context, const config::Settings& settings,
                       const std::vector<std::string>& defines, sim::ModelCache* cache) {
  return [&context, &settings, defines, cache](const golden::HardwareConfig& config,
                                               std::span<const golden::Word> stream) {
    ProgressLine line(context.show_progress);
    const auto progress = [&](double done) {
      context.interruption.check();
      line.update(cache == nullptr ? "golden" : "rtl", done);
    };
    if (cache == nullptr) return slb::run_golden(config, stream, progress);
    return slb::run_rtl(config, stream, progress, rtl_options(context, settings, defines), *cache);
  };
}

}  // namespace gnomon::cli
