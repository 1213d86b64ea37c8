// SPDX-License-Identifier: Apache-2.0
// How many cycles a second are simulated: of the units, of the hardware with its bus, of the whole system.
// What each adds is where the time goes.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <gnomon/golden/golden_engine.hpp>
#include <vector>

#include "sim/registers/registers.hpp"
#include "sim/rtl_engine.hpp"
#include "sim/system/system_engine.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::sim::system {
namespace {

namespace hw = registers::hardware;

golden::HardwareConfig build(bool slb) {
  golden::HardwareConfig config;
  config.en_slb = slb;
  return config;
}

/// Mostly voxels (and outlines and queries), in commands of up to 4,000.
std::vector<Word> commands(const golden::HardwareConfig& config) {
  return stimulus::random_stream(config,
                                 {.seed = 1, .commands = 200, .max_items = 4000, .illegal_percent = 0});
}

void count(benchmark::State& state, std::uint64_t cycles, std::uint64_t results) {
  state.counters["cycles"] = benchmark::Counter(static_cast<double>(cycles), benchmark::Counter::kIsRate);
  state.counters["results"] = benchmark::Counter(static_cast<double>(results), benchmark::Counter::kIsRate);
}

template <class Engine>
void run_stream(benchmark::State& state, Engine& engine) {
  const std::vector<Word> words = commands(engine.config());
  std::uint64_t results = 0;
  for (auto _ : state) {
    engine.submit(words);
    engine.drain([&](std::span<const Word> more) { results += more.size(); });
  }
  count(state, engine.cycle(), results);
}

void units(benchmark::State& state) {
  const auto engine = make_rtl_engine(build(state.range(0) != 0), {});
  run_stream(state, *engine);
}

/// gnomon_top over a memory that answers after 20 cycles, without a system around it.
class BareTop {
 public:
  explicit BareTop(const golden::HardwareConfig& config)
      : model_(ModelCache().load_top(model_spec(config, {})), 1), memory_(std::size_t{64} << 20U) {
    write(hw::kCommandSizeOffset, 1);
    write(hw::kResultBaseLowOffset, kResults);
    write(hw::kResultSizeOffset, 20);
    write(hw::kControlOffset, hw::kControlEnableMask);
  }
  void run(std::span<const Word> words) {
    const std::array<Word, 2> descriptor{kWords, words.size() | Word{1} << 48U};
    std::memcpy(&memory_[tail_ % 2 * sizeof descriptor], descriptor.data(), sizeof descriptor);
    std::memcpy(&memory_[kWords], words.data(), words.size_bytes());
    write(hw::kResultTailOffset, read(hw::kResultHeadOffset));
    write(hw::kCommandHeadOffset, ++tail_);
    while (read(hw::kCommandTailOffset) != tail_) {
      const std::uint64_t until = model_.cycle() + 1000;
      while (model_.cycle() < until) {
        model_.run(until);
        serve();
      }
    }
  }
  std::uint64_t cycle() const { return model_.cycle(); }
  std::uint64_t results() { return read(hw::kResultHeadOffset); }

 private:
  static constexpr std::uint32_t kResults = 32U << 20U, kWords = 4096, kLatency = 20;

  void serve() {
    GnomonTopRead read{};
    while (model_.take(read))
      model_.answer(read, read.cycle + kLatency, std::span(memory_).subspan(read.address, read.bytes), 0);
    GnomonTopWrite write{};
    while (model_.take(write)) {
      for (std::uint32_t i = 0; i < write.bytes; ++i)
        if ((write.strobe >> i & 1U) != 0) memory_[write.address + i] = write.data[i];
      model_.answer(write, write.cycle + kLatency, 0);
    }
  }
  std::uint32_t finish_access() {
    for (int events = 0; (events & GNOMON_TOP_ACCESS) == 0; serve()) events = model_.run(UINT64_MAX);
    std::uint32_t data = 0;
    model_.end_access(data);
    return data;
  }
  std::uint32_t read(std::uint32_t offset) {
    model_.begin_read(offset);
    return finish_access();
  }
  void write(std::uint32_t offset, std::uint32_t value) {
    model_.begin_write(offset, value);
    finish_access();
  }

  TopModel model_;
  std::vector<std::uint8_t> memory_;
  std::uint32_t tail_ = 0;
};

void with_bus(benchmark::State& state) {
  const golden::HardwareConfig config = build(state.range(0) != 0);
  const std::vector<Word> words = commands(config);
  BareTop top(config);
  for ([[maybe_unused]] auto round : state) top.run(words);
  count(state, top.cycle(), top.results());
}

void within_system(benchmark::State& state, HardwareModel hardware) {
  SystemOptions options;
  options.hardware = hardware;
  const auto engine = make_system_engine(build(state.range(0) != 0), options);
  run_stream(state, *engine);
}
void system_top(benchmark::State& state) {
  within_system(state, HardwareModel::Top);
}
void system_core(benchmark::State& state) {
  within_system(state, HardwareModel::Core);
}
void system_golden(benchmark::State& state) {
  within_system(state, HardwareModel::Golden);
}

BENCHMARK(units)->ArgName("slb")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(with_bus)->ArgName("slb")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(system_top)->ArgName("slb")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(system_core)->ArgName("slb")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(system_golden)->ArgName("slb")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon::sim::system

BENCHMARK_MAIN();
