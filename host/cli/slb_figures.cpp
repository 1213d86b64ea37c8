// SPDX-License-Identifier: Apache-2.0
// What `gnomon slb` says about a run.
#include "host/cli/slb_figures.hpp"

#include <fmt/format.h>

#include <string_view>

#include "host/slb/costs.hpp"

namespace gnomon::cli {
namespace {

using Json = nlohmann::ordered_json;

/// "cycles.DRAW.BUSY" -> {"DRAW": {"BUSY": ...}}.
Json cycles_by_pass(const golden::Counters& counters) {
  Json passes = Json::object();
  for (const auto& [name, cycles] : counters.cycles) {
    const std::size_t pass = name.find('.') + 1, cause = name.find('.', pass);
    passes[name.substr(pass, cause - pass)][name.substr(cause + 1)] = cycles;
  }
  return passes;
}

std::uint64_t event(const slb::EngineRun& run, const std::string& name) {
  const auto found = run.counters.events.find(name);
  return found == run.counters.events.end() ? 0 : found->second;
}

/// Cycles for each `count` of things, null without either.
Json each(double cycles, std::uint64_t count, bool measured) {
  return measured && count > 0 ? Json(cycles / static_cast<double>(count)) : Json();
}

double pass_cycles(const Json& passes, const char* pass) {
  double sum = 0;
  if (passes.contains(pass)) {
    for (const auto& [cause, cycles] : passes.at(pass).items()) sum += cycles.get<double>();
  }
  return sum;
}

}  // namespace

Json slb_figures(const SlbJob& job, const slb::EngineRun& run, double seconds) {
  const golden::slb::SlbConfig slb = job.config.slb_config();
  const slb::Costs costs = slb::buffer_costs(job.config, run.counters);
  const Json passes = cycles_by_pass(run.counters);
  Json figures = {
      {"loops", job.loops_file.string()},
      {"configuration", slb_configuration(job.config)},
      {"engine", run.compare ? "rtl" : "golden"},
      {"queries", event(run, "SLB_QUERIES")},
      {"shadow", event(run, "SLB_QUERIES_SHADOW")},
      {"off_plane", event(run, "SLB_QUERIES_OFF_PLANE")},
      {"overflow",
       {{"chains_dropped", event(run, "SLB_CHAINS_DROPPED")},
        {"chains_reduced", event(run, "SLB_CHAINS_REDUCED")},
        {"groups_evicted", event(run, "SLB_GROUPS_EVICTED")},
        {"winding_saturated", event(run, "SLB_WINDING_SATURATED")},
        {"loops_tiny", event(run, "SLB_LOOPS_TINY")},
        {"queries", event(run, "SLB_QUERIES_OVERFLOW")}}},
      {"memory",
       {{"bits_per_pixel", slb.entry_bits()},
        {"stored_bits_per_pixel", slb.stored_entry_bits()},
        {"bits", costs.memory_bits}}},
      {"events", run.counters.events},
      {"cycles", passes},
      {"cycles_per_crossing", each(pass_cycles(passes, "DRAW"), event(run, "SLB_CROSSINGS"), costs.measured)},
      {"cycles_per_query", each(costs.query_cycles, event(run, "SLB_QUERIES"), costs.measured)},
      {"seconds", {{"total", seconds}, {"golden", run.golden_seconds}, {"rtl", run.rtl_seconds}}}};
  if (run.compare) figures["compare"] = sim::to_json(*run.compare);
  return figures;
}

std::string slb_summary(const Json& figures) {
  const Json& overflow = figures.at("overflow");
  std::string text =
      fmt::format("{} queries, {} in shadow; {} of them where something did not fit\n",
                  figures.at("queries").get<std::uint64_t>(), figures.at("shadow").get<std::uint64_t>(),
                  overflow.at("queries").get<std::uint64_t>());
  text += fmt::format("{}: {} bits a pixel\n", figures.at("configuration").get<std::string>(),
                      figures.at("memory").at("stored_bits_per_pixel").get<int>());
  for (const auto& [what, count] : overflow.items()) {
    if (what != "queries" && count.get<std::uint64_t>() > 0)
      text += fmt::format("overflow: {} {}\n", count.get<std::uint64_t>(), what);
  }
  for (const char* rate : {"cycles_per_crossing", "cycles_per_query"}) {
    if (figures.at(rate).is_number())
      text += fmt::format("{}: {:.3f}\n", rate, figures.at(rate).get<double>());
  }
  return text;
}

}  // namespace gnomon::cli
