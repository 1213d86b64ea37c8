// SPDX-License-Identifier: Apache-2.0
// How many cycles a second the system is simulated, with golden and with the RTL inside.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <fstream>
#include <gnomon/golden/golden_engine.hpp>
#include <iterator>
#include <vector>

#include "sim/rtl_engine.hpp"
#include "sim/system/system_engine.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::sim::system {
namespace {

std::vector<std::uint8_t> firmware() {
  std::ifstream file(GNOMON_FIRMWARE_IMAGE, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Mostly voxels, in commands of up to 4,000.
std::vector<golden::Word> commands() {
  return stimulus::random_stream({}, {.seed = 1, .commands = 200, .max_items = 4000, .illegal_percent = 0});
}

void run_stream(benchmark::State& state, std::unique_ptr<golden::Engine> inner, EngineClock clock) {
  const std::vector<golden::Word> words = commands();
  SystemEngine engine({}, std::move(inner), firmware(), std::move(clock));
  std::uint64_t results = 0;
  for ([[maybe_unused]] auto round : state) {
    engine.submit(words);
    engine.drain([&](std::span<const golden::Word> more) { results += more.size(); });
  }
  const double cycles = static_cast<double>(engine.system().statistics().cycles);
  state.counters["cycles"] = benchmark::Counter(cycles, benchmark::Counter::kIsRate);
  state.counters["results"] = benchmark::Counter(static_cast<double>(results), benchmark::Counter::kIsRate);
}

void golden_inside(benchmark::State& state) {
  run_stream(state, golden::make_golden_engine({}), {});
}
void rtl_inside(benchmark::State& state) {
  auto rtl = make_rtl_engine({}, {});
  const RtlEngine* const engine = rtl.get();
  run_stream(state, std::move(rtl), [engine] { return engine->cycle(); });
}
BENCHMARK(golden_inside)->Unit(benchmark::kMillisecond);
BENCHMARK(rtl_inside)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon::sim::system

BENCHMARK_MAIN();
