// SPDX-License-Identifier: Apache-2.0
// Predicted cycles against those of the RTL, pass by pass, for command streams in files: the table of
// docs/cycle-model.md. `scripts/cycle-model-table` makes the streams.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/counter_names.hpp"
#include "sim/rtl_engine.hpp"

namespace {

using namespace gnomon;

/// Few models serve many scenes: all have every projection, and pools as large as any.
golden::HardwareConfig widened(golden::HardwareConfig config) {
  config.en_perspective = true;
  if (config.en_vpu_topology) {
    config.nodes_log2 = std::max(config.nodes_log2, 18);
    config.quads_log2 = std::max(config.quads_log2, 16);
  }
  return config;
}

class Engines {
 public:
  sim::RtlEngine& of(const golden::HardwareConfig& config) {
    for (const auto& engine : engines_)
      if (engine->config() == config) return *engine;
    engines_.push_back(sim::make_rtl_engine(config, {}));
    return *engines_.back();
  }

 private:
  std::vector<std::unique_ptr<sim::RtlEngine>> engines_;
};

/// Of a pass in all streams.
struct Sum {
  std::uint64_t streams = 0, measured = 0, predicted = 0, causes_off = 0, worst = 0;
};

std::uint64_t distance(std::uint64_t a, std::uint64_t b) {
  return a > b ? a - b : b - a;
}

void compare(const std::string& name, const golden::StreamFile& file, Engines& engines,
             std::array<Sum, golden::kPasses>& sums) {
  const golden::HardwareConfig config = widened(file.config);
  sim::RtlEngine& rtl = engines.of(config);
  rtl.reset();
  rtl.submit(file.words);
  rtl.drain([](std::span<const golden::Word>) {});
  const std::map<std::string, std::uint64_t> measured = rtl.counters().cycles;
  const golden::CycleTable predicted = golden::predict_cycles(config, {}, file.words);
  std::uint64_t all = 0, off = 0;
  for (std::size_t p = 1; p < golden::kPasses; ++p) {
    std::uint64_t cycles = 0, causes_off = 0;
    for (std::size_t c = 0; c < golden::kCauses; ++c) {
      const std::uint64_t cell = measured.at(sim::cycle_counter_name(p, c));
      cycles += cell;
      causes_off += distance(cell, predicted.at(static_cast<golden::Pass>(p), static_cast<golden::Cause>(c)));
    }
    if (cycles == 0) continue;
    const std::uint64_t model = predicted.of(static_cast<golden::Pass>(p));
    Sum& sum = sums.at(p);
    ++sum.streams;
    sum.measured += cycles;
    sum.predicted += model;
    sum.causes_off += causes_off;
    sum.worst = std::max(sum.worst, distance(cycles, model));
    all += cycles;
    off += distance(cycles, model);
  }
  fmt::print("| {} | {} | {} | {} |\n", name, file.words.size(), all, off);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) {
    fmt::print(stderr, "usage: cycle_model_table STREAM.gnomon...\n");
    return 2;
  }
  Engines engines;
  std::array<Sum, golden::kPasses> sums{};
  fmt::print("| stream | words | cycles | off, passes added up |\n|---|---|---|---|\n");
  for (int i = 1; i < argc; ++i) {
    const std::filesystem::path path = argv[i];
    const auto file = golden::load_stream(path);
    if (const auto* error = std::get_if<std::string>(&file)) {
      fmt::print(stderr, "{}\n", *error);
      return 2;
    }
    compare(path.parent_path().filename().string() + " " + path.stem().string(),
            std::get<golden::StreamFile>(file), engines, sums);
  }
  fmt::print(
      "\n| pass | streams | cycles | predicted | worst of a stream | causes, off "
      "|\n|---|---|---|---|---|---|\n");
  std::uint64_t off = 0;
  for (std::size_t p = 1; p < golden::kPasses; ++p) {
    const Sum& sum = sums.at(p);
    fmt::print("| {} | {} | {} | {} | {} | {} |\n", sim::kPassNames.at(p), sum.streams, sum.measured,
               sum.predicted, sum.worst, sum.causes_off);
    off += sum.worst + sum.causes_off;
  }
  return off == 0 ? 0 : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "cycle_model_table: {}\n", error.what());
  return 3;
}
