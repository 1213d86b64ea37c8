// SPDX-License-Identifier: Apache-2.0
// One model a build; each stream under one of the ways of holding back the ports, in turn.
#include "tests/sim/build_soak.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>

#include "tests/sim/cosim.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/frame_stream.hpp"
#include "tests/support/random.hpp"

namespace gnomon::sim::test {
namespace {

using golden::HardwareConfig;
using golden::slb::SlbOp;
using Streams = std::vector<stimulus::DirectedStream>;

constexpr std::uint64_t kFewestWords = 20'000;

struct Build {
  HardwareConfig config;
  RtlOptions options;
};

/// Latencies, stalls and dividers are the build's number's: the same every time.
std::vector<Build> builds() {
  std::vector<HardwareConfig> configs = stimulus::slb_covering_array();
  for (const auto& more : {stimulus::large_slb_configs(), stimulus::frame_covering_array()})
    configs.insert(configs.end(), more.begin(), more.end());
  configs.push_back(stimulus::large_frame_config());
  std::vector<Build> result;
  for (const HardwareConfig& config : configs) {
    static constexpr std::array kLatencies{1, 2, 3, 5, 17, 64};
    stimulus::Random random(1000 + result.size());
    RtlOptions options = Cosim::checked();
    options.quick_build = true;
    options.memory_latency = random.pick(std::span<const int>(kLatencies));
    options.memory_stall_seed = random.chance(60) ? static_cast<int>(random.between(1, 65535)) : 0;
    options.slb_dividers = static_cast<int>(random.between(1, 3));
    options.seed = static_cast<std::uint32_t>(random.bits());
    result.push_back({config, options});
  }
  return result;
}

bool is_large(const HardwareConfig& config) {
  return std::max(config.plane_log2, config.slb_plane_log2) > 9 ||
         (config.en_frame_buffer && config.voxel_bits > 7);
}

/// Ends whatever object a stream has left open; answered by errors where there is none.
void append_end_of_object(std::vector<Word>& words) {
  for (const SlbOp op : {SlbOp::Loop, SlbOp::Fill, SlbOp::EndObject}) {
    words.push_back(golden::encode(golden::Header{static_cast<std::uint8_t>(op), 0, 0, 0}));
  }
}

/// All of them as one stream: a large plane is scrubbed after every reset.
stimulus::DirectedStream joined(const Streams& streams) {
  stimulus::DirectedStream all{"all streams, one after the other", {}};
  for (const stimulus::DirectedStream& stream : streams) {
    all.words.insert(all.words.end(), stream.words.begin(), stream.words.end());
    append_end_of_object(all.words);
  }
  return all;
}

Streams streams_for(const HardwareConfig& config) {
  const bool large = is_large(config);
  Streams streams;
  // Directed objects cover the plane, again and again: above 2^10 that is minutes of fills.
  if (!config.en_slb || config.slb_plane_log2 <= 10) streams = stimulus::directed_streams(config);
  for (std::uint64_t seed = 1; seed <= (large ? 2 : kStallProfiles); ++seed)
    streams.push_back(random_case(config, seed, 300));
  for (std::uint64_t seed = 1; config.en_vpu_topology && seed <= kStallProfiles; ++seed)
    streams.push_back(topology_case(config, seed, 60));
  for (std::uint64_t seed = 1; config.en_frame_buffer && seed <= kStallProfiles; ++seed)
    streams.push_back(
        {fmt::format("frame buffer, seed {}", seed), stimulus::frame_stream(config, seed, 200)});
  if (!large) return streams;
  return {joined(streams)};
}

/// Adds the results of the streams that meet their ports held back in this way.
struct Totals {
  std::uint64_t streams = 0, words = 0, differing = 0, cycles = 0;
  bool passed = true;

  void add(const stimulus::DirectedStream& stream, const CompareReport& report) {
    ++streams;
    words += report.words_compared;
    differing += report.words_differing;
    cycles += report.cycles;
    if (report.passed()) return;
    passed = false;
    fmt::print("FAILED: {}\n{}\n", stream.name, to_text(report));
  }
};

Totals run(const Build& build) {
  const Streams streams = streams_for(build.config);
  const bool one_stream = streams.size() == 1;
  Totals totals;
  for (int kind = 0; kind < kStallProfiles; ++kind) {
    if (one_stream && kind != 0 && kind != 3) continue;  // free, and both ports held back
    RtlOptions options = build.options;
    options.stalls = stall_profile(kind, options.seed);
    Cosim cosim(build.config, options);
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (one_stream || i % kStallProfiles == static_cast<std::size_t>(kind))
        totals.add(streams[i], cosim.run(streams[i].words));
    }
  }
  return totals;
}

}  // namespace

int soak_builds(std::uint64_t first) {
  int failures = 0, done = 0;
  Totals sum;
  const std::vector<Build> all = builds();
  for (std::size_t number = std::max<std::size_t>(first, 1); number <= all.size(); ++number) {
    const Build& build = all.at(number - 1);
    ++done;
    const Totals totals = run(build);
    const bool enough = totals.words >= kFewestWords;
    fmt::print(
        "{:2} {} words compared, {} differing, {} streams, {} cycles{}: {} MEM_LATENCY={} "
        "MEM_STALL_SEED={} SLB_DIVIDERS={}\n",
        number, totals.words, totals.differing, totals.streams, totals.cycles,
        totals.passed ? (enough ? "" : " TOO FEW") : " FAILED", describe(build.config),
        build.options.memory_latency, build.options.memory_stall_seed, build.options.slb_dividers);
    std::fflush(stdout);
    failures += totals.passed && enough ? 0 : 1;
    sum.words += totals.words;
    sum.differing += totals.differing;
    sum.cycles += totals.cycles;
  }
  fmt::print("{} builds: {} words compared in {} cycles, {} differing, {} builds failed\n", done, sum.words,
             sum.cycles, sum.differing, failures);
  return failures;
}

}  // namespace gnomon::sim::test
