// SPDX-License-Identifier: Apache-2.0
// The tables of docs/system-model.md, "Behind a cache": cycles of a stream's passes in the whole system, with
// planes and lists in DRAM behind caches of several sizes, and what share of the on-chip throughput that is.
// Every word is compared with golden's. A stream is what `gnomon run` leaves behind.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <bit>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "sim/compare.hpp"
#include "sim/counter_names.hpp"
#include "sim/system/system_engine.hpp"

namespace {

using namespace gnomon;
using sim::system::SystemOptions;

struct Asked {
  std::string stream;
  std::vector<std::uint32_t> latencies{20, 50, 100, 200}, caches{4, 8, 16, 32, 64};
  std::uint32_t bits = 128, line_ids = 16;
  bool quick = false, passes = false;
};

/// Of a run: passes that make a picture, and of them what the stream is about.
struct Cycles {
  std::uint64_t main = 0, all = 0;
};

std::uint64_t of_pass(const golden::Counters& counters, std::string_view pass) {
  std::uint64_t sum = 0;
  for (const std::string_view cause : sim::kCauseNames)
    sum += counters.cycles.at(fmt::format("cycles.{}.{}", pass, cause));
  return sum;
}

/// Clearing, reading back, FENCE and waiting for software are left out.
Cycles cycles_of(const golden::HardwareConfig& config, const golden::Counters& counters, bool tell) {
  Cycles cycles;
  for (const std::string_view pass : {"PROJECT", "RESOLVE", "DRAW", "FILL", "COVER", "QUERY"}) {
    const std::uint64_t sum = of_pass(counters, pass);
    cycles.all += sum;
    if (config.en_slb ? pass == "QUERY" : config.en_vpu_topology ? pass == "RESOLVE" : true)
      cycles.main += sum;
    if (tell && sum != 0) fmt::print(stderr, " {} {}", pass, sum);
  }
  if (tell) fmt::print(stderr, "\n");
  return cycles;
}

/// Throws where a word differs.
Cycles run(sim::RtlEngine& engine, const golden::StreamFile& file, std::uint64_t& words, bool tell) {
  const auto reference = golden::make_golden_engine(file.config);
  const sim::CompareReport report = sim::compare(*reference, engine, file.words);
  if (!report.passed()) throw std::runtime_error(sim::to_text(report));
  words = report.words_compared;
  return cycles_of(file.config, report.rtl_counters, tell);
}

SystemOptions options_of(const Asked& asked, std::uint32_t kib, std::uint32_t latency) {
  SystemOptions options;
  options.cache_log2 = 10 + std::countr_zero(kib);
  options.line_ids_log2 = std::countr_zero(asked.line_ids);
  options.axi_data_bits = static_cast<int>(asked.bits);
  options.system.dram.latency = latency;
  options.system.dram.bytes_per_cycle = asked.bits / 4;  // twice the way's
  options.rtl.quick_build = asked.quick;
  return options;
}

double share(std::uint64_t part, std::uint64_t whole) {
  return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void print_table(const Asked& asked, const golden::StreamFile& file) {
  std::uint64_t words = 0;
  sim::RtlOptions rtl;
  rtl.quick_build = asked.quick;
  const Cycles on_chip = run(*sim::make_rtl_engine(file.config, rtl), file, words, asked.passes);
  const bool parts = on_chip.main != on_chip.all;
  fmt::print("{} words compared at each point; on chip {} cycles{}; {} bits, {} lines under way\n\n| cache |",
             words, on_chip.main, parts ? fmt::format(", {} in all", on_chip.all) : "", asked.bits,
             asked.line_ids);
  for (const std::uint32_t latency : asked.latencies) fmt::print(" {} |", latency);
  fmt::print("\n|---|");
  for (std::size_t i = 0; i < asked.latencies.size(); ++i) fmt::print("---|");
  for (const std::uint32_t kib : asked.caches) {
    fmt::print("\n| {} KiB |", kib);
    for (const std::uint32_t latency : asked.latencies) {
      if (asked.passes) fmt::print(stderr, "{} KiB, {}:", kib, latency);
      const auto engine = sim::system::make_system_engine(file.config, options_of(asked, kib, latency));
      const Cycles cycles = run(*engine, file, words, asked.passes);
      fmt::print(" {} = {:.1f} %", cycles.main, share(on_chip.main, cycles.main));
      fmt::print("{} |", parts ? fmt::format("; {:.1f} %", share(on_chip.all, cycles.all)) : "");
      std::fflush(stdout);
    }
  }
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) try {
  Asked asked;
  CLI::App app{"Cycles and shares of a stream behind caches, in the whole system"};
  app.add_option("STREAM", asked.stream)->required();
  app.add_option("--latency", asked.latencies, "of DRAM's controller and wires")->delimiter(',');
  app.add_option("--cache", asked.caches, "KiB a unit")->delimiter(',');
  app.add_option("--bits", asked.bits, "of the way to memory; DRAM moves twice as many a cycle");
  app.add_option("--line-ids", asked.line_ids, "lines that may be under way each way: 8, 16, 32");
  app.add_flag("--quick", asked.quick, "models that are compiled in less time");
  app.add_flag("--passes", asked.passes, "tell the cycles of each pass, on stderr");
  CLI11_PARSE(app, argc, argv);
  const auto file = golden::load_stream(asked.stream);
  if (const auto* error = std::get_if<std::string>(&file)) {
    fmt::print(stderr, "{}\n", *error);
    return 2;
  }
  print_table(asked, std::get<golden::StreamFile>(file));
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "memory_tables: {}\n", error.what());
  return 3;
}
