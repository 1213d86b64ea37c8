// SPDX-License-Identifier: Apache-2.0
// sim_coverage: runs the co-simulation's stimulus on models that count lines, toggles and cover points, and
// lists what was never reached.
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <fstream>
#include <gnomon/golden/golden_engine.hpp>

#include "tests/rtl/perspective/projection_streams.hpp"
#include "tests/sim/cosim.hpp"
#include "tests/sim/coverage_points.hpp"
#include "tests/sim/functional_bins.hpp"
#include "tests/support/frame_stream.hpp"

namespace gnomon::sim::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kRandomStreams = 5;

/// Topology mode, the perspective projection and the frame buffer.
golden::HardwareConfig projection_and_frame() {
  golden::HardwareConfig config = rtl_test::perspective_build();
  config.en_frame_buffer = true;
  config.frame_layers_log2 = 1;
  return config;
}

/// Each kind of hardware that the tests run: with and without resolve pass, with a slow and stalling plane;
/// so too with the silhouette-line buffer, and with everything else.
std::vector<std::pair<golden::HardwareConfig, RtlOptions>> hardware() {
  const golden::HardwareConfig with{.plane_log2 = 6}, without{.plane_log2 = 6, .en_vpu_offset = false},
      slb{.plane_log2 = 6, .en_slb = true, .slb_plane_log2 = 5};
  RtlOptions plain = Cosim::checked();
  plain.coverage = true;
  RtlOptions slow = plain;
  slow.memory_latency = 3;
  slow.memory_stall_seed = 99;
  const golden::HardwareConfig rest = projection_and_frame();
  return {{with, plain}, {with, slow}, {without, plain}, {slb, slow}, {rest, slow}};
}

std::vector<stimulus::DirectedStream> streams_for(const golden::HardwareConfig& config,
                                                  std::uint64_t first_seed) {
  std::vector<stimulus::DirectedStream> streams = stimulus::directed_streams(config);
  for (std::uint64_t seed = 1; seed <= kRandomStreams; ++seed)
    streams.push_back(random_case(config, first_seed + seed, 300));
  if (!config.en_frame_buffer) return streams;
  for (std::uint64_t seed = 1; seed <= kRandomStreams; ++seed)
    streams.push_back({fmt::format("frame buffer, seed {}", first_seed + seed),
                       stimulus::frame_stream(config, first_seed + seed, 300)});
  for (const rtl_test::ProjectionCase& one : rtl_test::projection_cases(10))
    streams.push_back({one.name, one.words});
  return streams;
}

void run_all(const fs::path& folder, CoverageCounts& points, FunctionalBins& bins) {
  int file_number = 0;
  for (auto& [config, options] : hardware()) {
    for (const int stalls : {0, 3, 4}) {  // free, cycle by cycle, long waits
      options.stalls = stall_profile(stalls, 5);
      Cosim cosim(config, options);
      for (const stimulus::DirectedStream& stream :
           streams_for(config, 100 * static_cast<std::uint64_t>(stalls))) {
        const CompareReport report = cosim.run(stream.words, {});
        if (!report.passed()) throw std::runtime_error(stream.name + "\n" + to_text(report));
        bins.add_cycles(report.rtl_counters);
        bins.add_stream(stream.words, config);
        const auto golden = golden::make_golden_engine(config);
        golden->submit(stream.words);
        golden->drain([&](std::span<const Word> words) { bins.add_results(words); });
      }
      const fs::path file = folder / fmt::format("run-{}.dat", file_number++);
      cosim.rtl().write_coverage(file);
      add_coverage(points, file);
    }
  }
}

struct Share {
  int reached = 0, all = 0;
  double percent() const { return all == 0 ? 100.0 : 100.0 * reached / all; }
};

void write_summary(std::ostream& out, const CoverageCounts& points, const FunctionalBins& bins) {
  std::map<std::string, std::map<std::string, Share>> files;
  for (const auto& [point, count] : points) {
    for (const std::string& name : {point.file, std::string("all")}) {
      Share& share = files[name][point.kind];
      ++share.all;
      share.reached += count != 0;
    }
  }
  for (const auto& [name, kinds] : files) {
    fmt::print(out, "{:<24}", name);
    for (const auto& [kind, share] : kinds) {
      fmt::print(out, " {} {}/{} ({:.1f} %)", kind, share.reached, share.all, share.percent());
    }
    fmt::print(out, "\n");
  }
  fmt::print(out, "\nnever reached in the RTL:\n");
  for (const auto& [point, count] : points) {
    if (count == 0) fmt::print(out, "  {}:{} {} {}\n", point.file, point.line, point.kind, point.name);
  }
  fmt::print(out, "\nfunctional bins never met:\n");
  Share met;
  for (const auto& [bin, count] : bins.counts()) {
    ++met.all;
    met.reached += count != 0;
    if (count == 0) fmt::print(out, "  {}\n", bin);
  }
  fmt::print(out, "{} of {} functional bins met\n", met.reached, met.all);
}

}  // namespace
}  // namespace gnomon::sim::test

int main(int argc, char** argv) {
  using namespace gnomon::sim::test;
  if (argc != 2) {
    fmt::print(stderr, "usage: sim_coverage FOLDER\n");
    return 2;
  }
  try {
    const fs::path folder = argv[1];
    fs::create_directories(folder);
    CoverageCounts points;
    FunctionalBins bins;
    run_all(folder, points, bins);
    std::ofstream summary(folder / "summary.txt");
    write_summary(summary, points, bins);
    fmt::print("{}\n", (folder / "summary.txt").string());
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
  return 0;
}
