// SPDX-License-Identifier: Apache-2.0
// The hardware against golden: one call a stream.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/compare.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::sim::test {

/// Engines of one configuration, kept for many streams.
class Cosim {
 public:
  explicit Cosim(const golden::HardwareConfig& config, const RtlOptions& options = checked());

  /// Resets both engines, compares every word, event counter and (where it is not huge) plane entry.
  CompareReport run(std::span<const Word> stream, const CompareOptions& options = {.plane = true});

  golden::Engine& golden() { return *golden_; }
  RtlEngine& rtl() { return *rtl_; }

  /// With the RTL's assertions.
  static RtlOptions checked();

 private:
  std::uint32_t seed_;
  std::unique_ptr<golden::Engine> golden_;
  std::unique_ptr<RtlEngine> rtl_;
};

/// Holding both ports back in many ways, one for each `kind` from 0 on; 0 holds back nothing.
StallProfile stall_profile(int kind, std::uint64_t seed);
inline constexpr int kStallProfiles = 6;

/// A random stream and its name for messages.
stimulus::DirectedStream random_case(const golden::HardwareConfig& config, std::uint64_t seed, int commands);
/// The same of topology mode, with commands of other kinds and in error between its own; `config` needs it.
stimulus::DirectedStream topology_case(const golden::HardwareConfig& config, std::uint64_t seed,
                                       int commands);

}  // namespace gnomon::sim::test
