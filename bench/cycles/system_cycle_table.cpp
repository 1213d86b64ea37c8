// SPDX-License-Identifier: Apache-2.0
// Predicted cycles against those of gnomon_top within the whole system, pass by pass, behind DRAM and caches:
// the second table of docs/cycle-model.md. Streams are those that `gnomon run` leaves behind.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <map>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "host/pipeline/cycle_timing.hpp"
#include "sim/counter_names.hpp"
#include "sim/system/system_engine.hpp"

namespace {

using namespace gnomon;
using sim::system::SystemOptions;

struct Asked {
  std::vector<std::string> streams;
  std::vector<std::uint32_t> latencies{20, 100, 200}, caches{0, 8, 32};
  std::uint32_t width = 8;
  bool quick = false;
};

SystemOptions options_of(const Asked& asked, std::uint32_t cache_kib, std::uint32_t latency) {
  SystemOptions options;
  options.cache_log2 = cache_kib == 0 ? 0 : 10 + std::countr_zero(cache_kib);
  options.system.dram.latency = latency;
  options.system.dram.bytes_per_cycle = asked.width;
  options.rtl.quick_build = asked.quick;
  return options;
}

/// Of a pass in all streams with one cache and one latency.
struct Sum {
  std::uint64_t streams = 0, measured = 0, predicted = 0;
  double worst = 0;  ///< of a stream, percent
};
/// By latency, cache and number of the pass; 0 is all of them.
using Sums = std::map<std::tuple<std::uint32_t, int, std::size_t>, Sum>;

double off(std::uint64_t predicted, std::uint64_t measured) {
  return 100 * (static_cast<double>(predicted) / static_cast<double>(measured) - 1);
}

int kib(int cache_log2) {
  return cache_log2 == 0 ? 0 : 1 << (cache_log2 - 10);
}

void compare(const std::string& name, const golden::StreamFile& file, const SystemOptions& options,
             Sums& sums) {
  const golden::HardwareTiming timing = pipeline::cycle_timing(options);
  const auto engine = sim::system::make_system_engine(file.config, options);
  engine->submit(file.words);
  engine->drain([](std::span<const golden::Word>) {});
  const std::map<std::string, std::uint64_t> measured = engine->counters().cycles;
  const golden::CycleTable predicted = golden::predict_cycles(file.config, timing, file.words);
  const std::uint32_t latency = options.system.dram.latency;
  const auto tell = [&](std::size_t pass, std::uint64_t cycles, std::uint64_t model) {
    if (cycles == 0) return;
    fmt::print("| {} | {} | {} | {} | {} | {} | {:+.2f} |\n", name, kib(options.cache_log2), latency,
               pass == 0 ? "all" : sim::kPassNames.at(pass), cycles, model, off(model, cycles));
    Sum& sum = sums[{latency, options.cache_log2, pass}];
    ++sum.streams;
    sum.measured += cycles;
    sum.predicted += model;
    sum.worst = std::max(sum.worst, std::abs(off(model, cycles)));
  };
  std::uint64_t all = 0, all_predicted = 0;
  for (std::size_t p = 1; p < golden::kPasses; ++p) {
    std::uint64_t cycles = 0;
    for (std::size_t c = 0; c < golden::kCauses; ++c) cycles += measured.at(sim::cycle_counter_name(p, c));
    const std::uint64_t model = predicted.of(static_cast<golden::Pass>(p));
    tell(p, cycles, model);
    all += cycles;
    all_predicted += model;
  }
  tell(0, all, all_predicted);
}

void print(const Sums& sums) {
  fmt::print(
      "\n| latency | cache, KiB | pass | streams | cycles | predicted | worst of a stream, % |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const auto& [key, sum] : sums) {
    const auto& [latency, cache_log2, pass] = key;
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f} |\n", latency, kib(cache_log2),
               pass == 0 ? "all" : sim::kPassNames.at(pass), sum.streams, sum.measured, sum.predicted,
               sum.worst);
  }
}

}  // namespace

int main(int argc, char** argv) try {
  Asked asked;
  CLI::App app{"Predicted cycles against those of the system"};
  app.add_option("STREAM", asked.streams)->required();
  app.add_option("--latency", asked.latencies)->delimiter(',');
  app.add_option("--cache", asked.caches, "KiB")->delimiter(',');
  app.add_option("--width", asked.width, "bytes a cycle of DRAM");
  app.add_flag("--quick", asked.quick, "models that are compiled in less time");
  CLI11_PARSE(app, argc, argv);
  Sums sums;
  fmt::print(
      "| stream | cache, KiB | latency | pass | cycles | predicted | off, % "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const std::filesystem::path path : asked.streams) {
    const auto file = golden::load_stream(path);
    if (const auto* error = std::get_if<std::string>(&file)) {
      fmt::print(stderr, "{}\n", *error);
      return 2;
    }
    for (const std::uint32_t cache : asked.caches)
      for (const std::uint32_t latency : asked.latencies)
        compare(path.parent_path().filename().string() + " " + path.stem().string(),
                std::get<golden::StreamFile>(file), options_of(asked, cache, latency), sums);
  }
  print(sums);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "system_cycle_table: {}\n", error.what());
  return 3;
}
