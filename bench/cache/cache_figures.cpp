// SPDX-License-Identifier: Apache-2.0
// The table of docs/cache.md: what share of the on-chip throughput a stream reaches with its planes in
// memory, for caches of several sizes and memories of several latencies.
//
//   cache_figures STREAM.gnomon [CYCLES_PER_LINE]
//
// Builds a model for each size (a minute each) under the current directory; a stream is what `gnomon run`
// leaves behind.
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "sim/model_spec.hpp"
#include "sim/process.hpp"
#include "sim/toolchain.hpp"

namespace {

namespace fs = std::filesystem;
using gnomon::golden::Word;

constexpr std::array<int, 6> kSizes{0, 12, 13, 14, 15, 16};
constexpr std::array<int, 4> kLatencies{20, 50, 100, 200};

struct Run {
  unsigned long long cycles = 0, results = 0, wrong = 0, reads = 0, writes = 0;
};

void write_words(const fs::path& path, std::span<const Word> words) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(words.data()), static_cast<std::streamsize>(words.size_bytes()));
}

void must(bool done, const std::string& what, const fs::path& log) {
  if (!done) throw std::runtime_error(what + " failed: see " + log.string());
}

/// Where run_words.cpp finds its headers.
std::string include_flags() {
  std::string flags = fmt::format("-I{}", GNOMON_SOURCE_DIR);
  for (const char* part : {"", "/perspective", "/slb", "/topology", "/frame"})
    flags += fmt::format(" -I{}/golden{}/include", GNOMON_SOURCE_DIR, part);
  return flags;
}

/// The model's program, with a cache of 2^size bytes; 0: planes on chip.
fs::path build(const gnomon::golden::HardwareConfig& config, int size, const fs::path& work) {
  const auto tools = gnomon::sim::Toolchain::from_environment();
  const fs::path folder = work / fmt::format("cache{}", size);
  fs::create_directories(folder);
  std::vector<std::string> command{tools.verilator};
  for (const std::string& argument : gnomon::sim::verilator_arguments({.config = config})) {
    if (argument != "--savable") command.push_back(argument);
  }
  const std::string flags = fmt::format("-O2 -std=c++20 {}", include_flags());
  for (const std::string& argument :
       {fmt::format("-GCACHE_LOG2={}", size), std::string("-F"), (tools.rtl_dir / "gnomon.f").string(),
        std::string("--exe"), std::string(GNOMON_SOURCE_DIR) + "/bench/cache/run_words.cpp",
        std::string("--build"), std::string("-j"), std::string("2"), std::string("-CFLAGS"), flags,
        std::string("--Mdir"), std::string("model"), std::string("-o"), std::string("run_words")})
    command.push_back(argument);
  must(gnomon::sim::Process(command, folder, folder / "build.log").succeeded(), "building a model",
       folder / "build.log");
  return folder / "model" / "run_words";
}

/// One run for each latency.
std::vector<Run> measure(const fs::path& program, const fs::path& work, const std::string& cycles_per_line,
                         std::span<const int> latencies) {
  const fs::path log = program.parent_path() / "runs";
  fs::remove(log);
  std::vector<std::string> command{program.string(), (work / "words").string(), (work / "expected").string(),
                                   cycles_per_line};
  for (const int latency : latencies) command.push_back(std::to_string(latency));
  must(gnomon::sim::Process(command, work, log).succeeded(), "running a model", log);
  std::vector<Run> runs;
  std::ifstream lines(log);
  int latency = 0;
  for (Run run; lines >> latency >> run.cycles >> run.results >> run.wrong >> run.reads >> run.writes;) {
    must(run.wrong == 0, "comparing results", log);
    runs.push_back(run);
  }
  must(runs.size() == latencies.size(), "running a model", log);
  return runs;
}

void print_table(const fs::path& stream, const fs::path& work, const std::string& cycles_per_line) {
  auto loaded = gnomon::golden::load_stream(stream);
  if (const auto* error = std::get_if<std::string>(&loaded)) throw std::runtime_error(*error);
  const auto& file = std::get<gnomon::golden::StreamFile>(loaded);
  const auto golden = gnomon::golden::make_golden_engine(file.config);
  std::vector<Word> expected;
  golden->submit(file.words);
  golden->drain(
      [&](std::span<const Word> some) { expected.insert(expected.end(), some.begin(), some.end()); });
  fs::create_directories(work);
  write_words(work / "words", file.words);
  write_words(work / "expected", expected);

  const Run on_chip = measure(build(file.config, 0, work), work, cycles_per_line, std::array{1}).front();
  fmt::print("{} words, {} results compared in each run, {} cycles on chip, {} cycles a line on the bus\n\n",
             file.words.size(), on_chip.results, on_chip.cycles, cycles_per_line);
  fmt::print("| cache | lines read | written |");
  for (const int latency : kLatencies) fmt::print(" {} cycles |", latency);
  fmt::print("\n|---|---|---|---|---|---|---|\n");
  for (const int size : std::span(kSizes).subspan(1)) {
    const std::vector<Run> runs = measure(build(file.config, size, work), work, cycles_per_line, kLatencies);
    fmt::print("| {} KiB | {} | {} |", (1 << size) / 1024, runs.front().reads, runs.front().writes);
    for (const Run& run : runs)
      fmt::print(" {:.1f} % |",
                 100.0 * static_cast<double>(on_chip.cycles) / static_cast<double>(run.cycles));
    fmt::print("\n");
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 3) {
    fmt::print(stderr, "usage: cache_figures STREAM.gnomon [CYCLES_PER_LINE]\n");
    return 2;
  }
  try {
    const fs::path stream = arguments[1];
    print_table(stream, fs::current_path() / ("cache_figures_" + stream.stem().string()),
                count > 2 ? arguments[2] : "8");
  } catch (const std::exception& error) {
    fmt::print(stderr, "cache_figures: {}\n", error.what());
    return 1;
  }
}
