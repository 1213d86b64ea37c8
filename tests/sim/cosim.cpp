// SPDX-License-Identifier: Apache-2.0
// Engines side by side.
#include "tests/sim/cosim.hpp"

#include <array>
#include <gnomon/golden/golden_engine.hpp>

#include "tests/rtl/topology/program_stream.hpp"

namespace gnomon::sim::test {

Cosim::Cosim(const golden::HardwareConfig& config, const RtlOptions& options)
    : seed_(options.seed),
      golden_(golden::make_golden_engine(config)),
      rtl_(make_rtl_engine(config, options)) {}

CompareReport Cosim::run(std::span<const Word> stream, const CompareOptions& options) {
  constexpr int kLargestPlaneReadBack = 6;
  golden_->reset();
  rtl_->reset();
  CompareOptions chosen = options;
  chosen.plane = options.plane && rtl_->config().plane_log2 <= kLargestPlaneReadBack;
  return compare(*golden_, *rtl_, stream, chosen, seed_);
}

RtlOptions Cosim::checked() {
  RtlOptions options;
  options.assertions = true;
  return options;
}

StallProfile stall_profile(int kind, std::uint64_t seed) {
  static const std::array<StallProfile, kStallProfiles> profiles{{
      {},
      {.command = {128, 0}},                      // holes in the input
      {.result = {128, 0}},                       // holes at the output
      {.command = {128, 0}, .result = {128, 0}},  // both, cycle by cycle
      {.command = {200, 5}, .result = {56, 5}},   // long waits at the output: everything fills up
      {.command = {24, 2}, .result = {230, 7}},   // mostly empty
  }};
  StallProfile profile = profiles.at(static_cast<std::size_t>(kind));
  profile.seed = seed;
  return profile;
}

stimulus::DirectedStream random_case(const golden::HardwareConfig& config, std::uint64_t seed, int commands) {
  stimulus::Options options;
  options.seed = seed;
  options.commands = commands;
  return {"random, seed " + std::to_string(seed), stimulus::random_stream(config, options)};
}

stimulus::DirectedStream topology_case(const golden::HardwareConfig& config, std::uint64_t seed,
                                       int commands) {
  // With a grid of 16 voxels a light's cone spreads each voxel over thousands of entries of the largest
  // planes.
  constexpr std::int64_t kMostEntries = 1 << 21;
  return {"topology mode, seed " + std::to_string(seed),
          rtl_test::topology::program_stream(
              config,
              {.seed = seed, .commands = commands, .doubtful_percent = 20, .most_entries = kMostEntries})};
}

}  // namespace gnomon::sim::test
