// SPDX-License-Identifier: Apache-2.0
// sim_soak: co-simulation of many seeds. A failing stream is shrunk and saved, with everything needed to
// repeat it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream_io.hpp>

#include "sim/interrupt.hpp"
#include "sim/shrink.hpp"
#include "tests/sim/build_soak.hpp"
#include "tests/sim/cosim.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/random.hpp"

namespace gnomon::sim::test {
namespace {

struct SoakOptions {
  std::uint64_t first_seed = 1;
  std::uint64_t seeds = 1000;
  int commands = 400;
  double seconds = 0;  ///< 0: no limit
  std::string failures = ".";
};

/// Everything that one seed decides.
struct Trial {
  golden::HardwareConfig config;
  RtlOptions options;
  std::vector<Word> stream;
};

/// Builds whose plane is scrubbed quickly after each reset.
std::vector<golden::HardwareConfig> quick_configs() {
  std::vector<golden::HardwareConfig> configs = stimulus::covering_array();
  std::erase_if(configs, [](const golden::HardwareConfig& config) { return config.plane_log2 > 9; });
  return configs;
}

Trial make_trial(std::uint64_t seed, int commands) {
  static const std::vector<golden::HardwareConfig> configs = quick_configs();
  stimulus::Random random(seed);
  Trial trial;
  trial.config = random.pick(std::span<const golden::HardwareConfig>(configs));
  trial.options = Cosim::checked();
  trial.options.seed = static_cast<std::uint32_t>(seed);
  trial.options.stalls = stall_profile(static_cast<int>(random.between(0, kStallProfiles - 1)), seed);
  if (random.chance(25)) trial.options.memory_stall_seed = 4711;
  const bool topology = trial.config.en_vpu_topology && random.chance(50);
  trial.stream =
      (topology ? topology_case(trial.config, seed, commands / 8) : random_case(trial.config, seed, commands))
          .words;
  return trial;
}

void keep_failure(const Trial& trial, std::uint64_t seed, const CompareReport& report,
                  const std::string& folder) {
  ModelCache cache;
  const StillFails fails = differs([&] { return golden::make_golden_engine(trial.config); },
                                   [&] { return make_rtl_engine(trial.config, trial.options, cache); });
  const Shrunk shrunk = shrink(trial.stream, fails);
  const std::filesystem::path file = std::filesystem::path(folder) / fmt::format("soak-{}.gnomon", seed);
  if (const auto error = golden::save_stream(file, trial.config, shrunk.stream))
    fmt::print(stderr, "{}\n", *error);
  const StallProfile& stalls = trial.options.stalls;
  fmt::print("seed {} FAILED\n{}shrunk to {} words: {}\n", seed, to_text(report), shrunk.stream.size(),
             file.string());
  fmt::print(
      "command port {}/256 in blocks of 2^{}, result port {}/256 in blocks of 2^{}, MEM_STALL_SEED={}\n",
      stalls.command.open_per_256, stalls.command.block_log2, stalls.result.open_per_256,
      stalls.result.block_log2, trial.options.memory_stall_seed);
  fmt::print("repeat: sim_soak --first {} --seeds 1\n", seed);
}

/// Number of failing seeds.
int soak(const SoakOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const InterruptFlag interrupt;
  std::uint64_t done = 0, words = 0, cycles = 0;
  int failures = 0;
  for (; done < options.seeds && !interrupt.flag().load(); ++done) {
    if (options.seconds > 0 && elapsed() > options.seconds) break;
    const std::uint64_t seed = options.first_seed + done;
    const Trial trial = make_trial(seed, options.commands);
    const CompareReport report = Cosim(trial.config, trial.options).run(trial.stream);
    words += report.words_compared;
    cycles += report.cycles;
    if (report.passed()) continue;
    ++failures;
    keep_failure(trial, seed, report, options.failures);
  }
  fmt::print("{} seeds from {}: {} words compared in {} cycles, {} seeds failed\n", done, options.first_seed,
             words, cycles, failures);
  return words == 0 ? 1 : failures;
}

}  // namespace
}  // namespace gnomon::sim::test

int main(int argc, char** argv) {
  gnomon::sim::test::SoakOptions options;
  CLI::App app{"Random co-simulation of the RTL against golden, seed by seed"};
  app.add_option("--first", options.first_seed, "first seed, or number of the first build")
      ->capture_default_str();
  app.add_option("--seeds", options.seeds, "number of seeds")->capture_default_str();
  app.add_option("--commands", options.commands, "commands a stream")->capture_default_str();
  app.add_option("--seconds", options.seconds, "stop after this time, 0 for never")->capture_default_str();
  app.add_option("--failures", options.failures, "folder for streams that fail")
      ->check(CLI::ExistingDirectory);
  bool builds = false;
  app.add_flag(
      "--builds", builds,
      "instead of seeds, every build of the covering arrays with the silhouette-line buffer or the frame "
      "buffer, and large planes and grids");
  CLI11_PARSE(app, argc, argv);
  try {
    if (builds) return gnomon::sim::test::soak_builds(options.first_seed) == 0 ? 0 : 1;
    return gnomon::sim::test::soak(options) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 3;
  }
}
