// SPDX-License-Identifier: Apache-2.0
// The buffer's error for several widths, next to shadow maps.
#include "host/slb/error_report.hpp"

#include <algorithm>

#include "host/slb/fixed_point.hpp"
#include "host/slb/loop_stream.hpp"

namespace gnomon::slb {
namespace {

nlohmann::ordered_json to_json(double displacement, const Costs& costs) {
  return {{"displacement", displacement},
          {"memory_bits", costs.memory_bits},
          {"draw_cycles", costs.draw_cycles},
          {"query_cycles", costs.query_cycles},
          {"cycles_measured", costs.measured}};
}

}  // namespace

Result<ErrorPoint> measure_error(const LoopScene& scene, const golden::HardwareConfig& config,
                                 const SampleOptions& options, const Runner& runner) {
  const golden::slb::SlbConfig slb = config.slb_config();
  const Result<std::vector<FixedCaster>> casters = to_fixed(scene, slb);
  if (!casters) return tl::make_unexpected(casters.error());
  const PolygonReference reference(scene, slb.side());
  const BorderSamples samples = border_samples(reference, slb, options);
  ErrorPoint point;
  point.config = config;
  point.run = runner(config, loop_stream(*casters, samples.queries, config, true));
  LoopResults results = decode_results(point.run.results, samples.queries.size(), config);
  point.displacement = displacement(samples, results.answers);
  point.entries = std::move(results.entries);
  point.buffer = buffer_costs(config, point.run.counters);
  point.plain_map = map_costs(config, point.run.counters, 1);
  point.fine_map = map_costs(config, point.run.counters, 1 << config.frac_bits);
  point.run.results.clear();
  return point;
}

std::vector<golden::HardwareConfig> report_configurations(const golden::HardwareConfig& config) {
  std::vector<golden::HardwareConfig> configurations;
  for (int frac_bits = 3; frac_bits <= 8; ++frac_bits) {
    golden::HardwareConfig one = config;
    one.frac_bits = frac_bits;
    one.slope_bits = std::clamp(frac_bits + config.slope_bits - config.frac_bits, 3, 9);
    const int least = std::max(frac_bits + 3, one.slope_bits - frac_bits + 4);
    one.subpixel_bits = std::max(config.subpixel_bits, least);
    one.query_bits = std::max(config.query_bits, frac_bits + 3);
    if (!one.check()) configurations.push_back(one);
  }
  return configurations;
}

nlohmann::ordered_json to_json(const ErrorPoint& point) {
  const Displacement& d = point.displacement;
  nlohmann::ordered_json json = {{"frac_bits", point.config.frac_bits},
                                 {"slope_bits", point.config.slope_bits},
                                 {"frags", point.config.frags_per_pixel},
                                 {"subpixel_bits", point.config.subpixel_bits},
                                 {"query_bits", point.config.query_bits},
                                 {"samples", d.samples},
                                 {"wrong", d.wrong},
                                 {"border", d.border},
                                 {"ratio", d.ratio()},
                                 {"gain", d.gain()},
                                 {"buffer", to_json(d.buffer, point.buffer)},
                                 {"plain_map", to_json(d.plain_map, point.plain_map)},
                                 {"fine_map", to_json(d.fine_map, point.fine_map)},
                                 {"events", point.run.counters.events},
                                 {"cycles", point.run.counters.cycles}};
  if (point.run.compare) json["compare"] = sim::to_json(*point.run.compare);
  return json;
}

}  // namespace gnomon::slb
