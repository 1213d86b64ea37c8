// SPDX-License-Identifier: Apache-2.0
// Voxels a second of both engines, and cycles a second of the rtl engine, on the same stream.
#include <benchmark/benchmark.h>

#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>

#include "sim/compare.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon {
namespace {

using golden::HardwareConfig;
using golden::Word;

constexpr std::size_t kVoxels = 200'000;

/// A tilted surface, projected and resolved: every voxel passes both passes once.
std::vector<Word> surface_stream(const HardwareConfig& config) {
  stimulus::Random random(1);
  const auto registers = stimulus::scene_registers(config, random);
  const auto voxels = stimulus::voxel_pattern(stimulus::Pattern::Sheet, kVoxels, registers, config, random);
  golden::StreamWriter writer(config);
  writer.set_registers(golden::Register::MatrixUx, registers);
  writer.project(voxels);
  writer.resolve(voxels, false);
  writer.fence(1, false);
  return writer.take();
}

void run(golden::Engine& engine, std::span<const Word> stream) {
  engine.submit(stream);
  engine.drain([](std::span<const Word> words) { benchmark::DoNotOptimize(words.data()); });
}

double voxels_of(const benchmark::State& state) {
  return static_cast<double>(state.iterations()) * static_cast<double>(kVoxels);
}

benchmark::Counter rate(double amount) {
  return {amount, benchmark::Counter::kIsRate};
}

void golden_engine(benchmark::State& state) {
  const HardwareConfig config;
  const std::vector<Word> stream = surface_stream(config);
  const auto engine = golden::make_golden_engine(config);
  while (state.KeepRunning()) run(*engine, stream);
  state.counters["voxels/s"] = rate(voxels_of(state));
}

/// The model is built before the clock starts. Argument 0: as users run it; 1: with assertions; 2: able to
/// trace.
void rtl_engine(benchmark::State& state) {
  const HardwareConfig config;
  const std::vector<Word> stream = surface_stream(config);
  sim::RtlOptions options;
  options.assertions = state.range(0) == 1;
  options.trace_model = state.range(0) == 2;
  const auto engine = sim::make_rtl_engine(config, options);
  run(*engine, {});  // the scrub after reset
  const std::uint64_t before = engine->cycle();
  while (state.KeepRunning()) run(*engine, stream);
  const auto cycles = static_cast<double>(engine->cycle() - before);
  const auto voxels = voxels_of(state);
  state.counters["voxels/s"] = rate(voxels);
  state.counters["cycles/s"] = rate(cycles);
  state.counters["cycles/voxel/pass"] = cycles / voxels / 2;
}

void verification(benchmark::State& state) {
  const HardwareConfig config;
  const std::vector<Word> stream = surface_stream(config);
  const auto reference = golden::make_golden_engine(config);
  const auto rtl = sim::make_rtl_engine(config, {});
  while (state.KeepRunning()) {
    reference->reset();
    rtl->reset();
    if (!sim::compare(*reference, *rtl, stream).passed()) state.SkipWithError("engines differ");
  }
  state.counters["voxels/s"] = rate(voxels_of(state));
}

BENCHMARK(golden_engine)->Unit(benchmark::kMillisecond);
BENCHMARK(rtl_engine)->ArgName("model")->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(verification)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon
