// SPDX-License-Identifier: Apache-2.0
// Predicted cycles against those of gnomon_top within the whole system, pass by pass, behind DRAM and caches:
// the rows from which `scripts/cycle-model-table --system` makes the second table of docs/cycle-model.md.
// Streams are those that `gnomon run` leaves behind.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <map>
#include <span>
#include <string>
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
  std::vector<std::uint32_t> latencies{20, 50, 100, 200}, caches{0, 8, 32};
  std::uint32_t width = 8;
  std::size_t questions = 0;
  bool quick = false, widen = false;
};

SystemOptions options_of(const Asked& asked, std::uint32_t cache_kib, std::uint32_t latency) {
  SystemOptions options;
  options.cache_log2 = cache_kib == 0 ? 0 : 10 + std::countr_zero(cache_kib);
  options.system.dram.latency = latency;
  options.system.dram.bytes_per_cycle = asked.width;
  options.rtl.quick_build = asked.quick;
  return options;
}

/// One model serves all scenes and techniques of a resolution and plane: it has all units and every
/// projection, and pools as large as any.
golden::HardwareConfig widened(golden::HardwareConfig config) {
  config.en_perspective = true;
  config.en_vpu_topology = true;
  config.en_slb = true;
  config.slb_plane_log2 = config.plane_log2;
  config.nodes_log2 = std::max(config.nodes_log2, 18);
  config.quads_log2 = std::max(config.quads_log2, 16);
  return config;
}

/// With only so many questions of QUERY and as many entries of READ_ENTRIES; 0: with all of them. They change
/// nothing, and of a scene's stream they are most.
std::vector<golden::Word> trimmed(std::span<const golden::Word> words, std::size_t most) {
  if (most == 0) return {words.begin(), words.end()};
  std::vector<golden::Word> kept;
  std::size_t questions = most, entries = most;
  for (std::size_t at = 0; at < words.size();) {
    golden::Header header = golden::decode_header(words[at]);
    const std::size_t length = header.count;
    bool keeps = true;
    if (header.op == static_cast<std::uint8_t>(golden::slb::SlbOp::Query)) {
      header.count = static_cast<std::uint16_t>(std::min(length, questions));
      keeps = length == 0 || header.count != 0;
      questions -= header.count;
    } else if (header.op == static_cast<std::uint8_t>(golden::slb::SlbOp::ReadEntries)) {
      const std::size_t count = golden::slb::decode_entry_range(header.arg).count;
      keeps = count <= entries;
      entries -= keeps ? count : 0;
    }
    const auto first = words.begin() + static_cast<std::ptrdiff_t>(at + 1);
    if (keeps) {
      kept.push_back(golden::encode(header));
      kept.insert(kept.end(), first, first + header.count);
    }
    at += 1 + length;
  }
  return kept;
}

std::uint64_t distance(std::uint64_t a, std::uint64_t b) {
  return a > b ? a - b : b - a;
}

/// A row for each pass that took any cycle.
void compare(const std::string& name, const golden::HardwareConfig& config,
             std::span<const golden::Word> words, const SystemOptions& options) {
  const golden::HardwareTiming timing = pipeline::cycle_timing(options);
  const auto engine = sim::system::make_system_engine(config, options);
  engine->submit(words);
  engine->drain([](std::span<const golden::Word>) {});
  const std::map<std::string, std::uint64_t> measured = engine->counters().cycles;
  const golden::CycleTable predicted = golden::predict_cycles(config, timing, words);
  const int kib = options.cache_log2 == 0 ? 0 : 1 << (options.cache_log2 - 10);
  for (std::size_t p = 1; p < golden::kPasses; ++p) {
    std::uint64_t cycles = 0, causes_off = 0;
    for (std::size_t c = 0; c < golden::kCauses; ++c) {
      const std::uint64_t cell = measured.at(sim::cycle_counter_name(p, c));
      cycles += cell;
      causes_off += distance(cell, predicted.at(static_cast<golden::Pass>(p), static_cast<golden::Cause>(c)));
    }
    if (cycles == 0) continue;
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", name, kib, options.system.dram.latency,
               sim::kPassNames.at(p), cycles, predicted.of(static_cast<golden::Pass>(p)), causes_off);
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  Asked asked;
  CLI::App app{"Predicted cycles against those of the system"};
  app.add_option("STREAM", asked.streams)->required();
  app.add_option("--latency", asked.latencies)->delimiter(',');
  app.add_option("--cache", asked.caches, "KiB")->delimiter(',');
  app.add_option("--width", asked.width, "bytes a cycle of DRAM");
  app.add_option("--questions", asked.questions,
                 "so many of QUERY, and as many entries of READ_ENTRIES; 0: all");
  app.add_flag("--quick", asked.quick, "models that are compiled in less time");
  app.add_flag("--widen", asked.widen, "all units in one model, for all streams of a resolution and plane");
  CLI11_PARSE(app, argc, argv);
  fmt::print(
      "| stream | cache, KiB | latency | pass | cycles | predicted | causes, off "
      "|\n|---|---|---|---|---|---|---|\n");
  for (const std::filesystem::path path : asked.streams) {
    const auto loaded = golden::load_stream(path);
    if (const auto* error = std::get_if<std::string>(&loaded)) {
      fmt::print(stderr, "{}\n", *error);
      return 2;
    }
    const auto& file = std::get<golden::StreamFile>(loaded);
    const golden::HardwareConfig config = asked.widen ? widened(file.config) : file.config;
    const std::vector<golden::Word> words = trimmed(file.words, asked.questions);
    const std::string name = path.parent_path().filename().string() + " " + path.stem().string();
    for (const std::uint32_t cache : asked.caches)
      for (const std::uint32_t latency : asked.latencies)
        compare(name, config, words, options_of(asked, cache, latency));
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "system_cycle_table: {}\n", error.what());
  return 3;
}
