// SPDX-License-Identifier: Apache-2.0
// Crossings, filled pixels and queries a second of the golden silhouette-line buffer, and whole points of a
// sweep.
#include <benchmark/benchmark.h>

#include <cmath>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/slb/model.hpp>
#include <gnomon/golden/stream.hpp>
#include <numbers>

namespace gnomon {
namespace {

using golden::HardwareConfig;
using golden::Word;
using golden::slb::QueryPoint;
using golden::slb::SlbConfig;
using golden::slb::SlbModel;
using golden::slb::Vertex;

/// A curve with `waves` waves around the middle of the plane, in edges of about a pixel: 3,000 crossings or
/// so on 256 pixels.
std::vector<Vertex> outline(const SlbConfig& config, int waves, double radius) {
  const double scale = static_cast<double>(config.subpixels()), centre = 0.5 * config.side();
  const int count = static_cast<int>(9.0 * config.side());
  std::vector<Vertex> loop;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double r = radius * config.side() * (1 + 0.35 * std::sin(waves * angle));
    const auto on_lattice = [&](double along) {
      return static_cast<std::int64_t>(std::llround((centre + r * along) * scale));
    };
    loop.push_back({on_lattice(std::cos(angle)), on_lattice(std::sin(angle)), 1000});
  }
  return loop;
}

/// A lattice over the whole plane, a little apart from pixel borders.
std::vector<QueryPoint> points(const SlbConfig& config, int count) {
  const int side = static_cast<int>(std::sqrt(count));
  const double step =
      static_cast<double>(config.side()) * static_cast<double>(std::int64_t{1} << config.query_bits) / side;
  std::vector<QueryPoint> list;
  list.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    list.push_back({static_cast<std::int64_t>((i % side + 0.37) * step),
                    static_cast<std::int64_t>((i / side % side + 0.41) * step), 2000});
  }
  return list;
}

HardwareConfig hardware(int bits) {
  HardwareConfig config;
  config.en_slb = true;
  config.frac_bits = config.slope_bits = bits;
  config.subpixel_bits = config.query_bits = bits + 3;
  return config;
}

void walk(benchmark::State& state) {
  const SlbConfig config = hardware(static_cast<int>(state.range(0))).slb_config();
  const std::vector<Vertex> loop = outline(config, 14, 0.33);
  SlbModel model(config);
  for ([[maybe_unused]] auto round : state) {
    model.begin_object(1, true, 1000);
    model.loop(loop);
    state.PauseTiming();
    model.fill();
    model.end_object();
    model.clear();
    state.ResumeTiming();
  }
  state.counters["crossings/s"] =
      benchmark::Counter(static_cast<double>(model.counters().crossings), benchmark::Counter::kIsRate);
  state.counters["crossings"] =
      static_cast<double>(model.counters().crossings) / static_cast<double>(state.iterations());
}
BENCHMARK(walk)->Arg(4)->Arg(7);

void fill(benchmark::State& state) {
  const SlbConfig config = hardware(7).slb_config();
  const std::vector<Vertex> loop = outline(config, 14, 0.33);
  SlbModel model(config);
  for ([[maybe_unused]] auto round : state) {
    state.PauseTiming();
    model.clear();
    model.begin_object(1, true, 1000);
    model.loop(loop);
    state.ResumeTiming();
    model.fill();
    state.PauseTiming();
    model.end_object();
    state.ResumeTiming();
  }
  state.counters["pixels/s"] =
      benchmark::Counter(static_cast<double>(model.counters().fill_pixels), benchmark::Counter::kIsRate);
}
BENCHMARK(fill);

void query(benchmark::State& state) {
  const SlbConfig config = hardware(7).slb_config();
  SlbModel model(config);
  model.begin_object(1, true, 1000);
  model.loop(outline(config, 14, 0.33));
  model.fill();
  model.end_object();
  const std::vector<QueryPoint> list = points(config, 20'000);
  for ([[maybe_unused]] auto round : state) {
    for (const QueryPoint& point : list) benchmark::DoNotOptimize(model.query(point, 3));
  }
  state.counters["queries/s"] =
      benchmark::Counter(static_cast<double>(model.counters().queries), benchmark::Counter::kIsRate);
}
BENCHMARK(query);

/// One point of a sweep: a new engine, four outlines, 20,000 queries, as a stream.
void sweep_point(benchmark::State& state) {
  const HardwareConfig config = hardware(static_cast<int>(state.range(0)));
  golden::StreamWriter writer(config);
  for (std::uint8_t object = 0; object < 4; ++object) {
    writer.begin_object(object, 1000u + object);
    writer.loop(outline(config.slb_config(), 14, 0.33 - 0.03 * object));
    writer.fill();
    writer.end_object();
  }
  writer.query(points(config.slb_config(), 20'000), 3);
  const std::vector<Word> stream = writer.take();
  for ([[maybe_unused]] auto round : state) {
    const auto engine = golden::make_golden_engine(config);
    engine->submit(stream);
    engine->drain([](std::span<const Word> words) { benchmark::DoNotOptimize(words.data()); });
  }
  state.counters["points/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(sweep_point)->Arg(4)->Arg(7)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gnomon
