// SPDX-License-Identifier: Apache-2.0
// Situations that a verification of the hardware should have met, seen from the streams alone.
#pragma once

#include <cstdint>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <span>
#include <string>

namespace gnomon::sim::test {

/// Counts of named situations. Every bin exists from the start, so that the ones never met show.
class FunctionalBins {
 public:
  FunctionalBins();

  /// Kinds of answers: combinations of VOXEL_STATE and SLB_ANSWER fields, errors, sticky flags, plane
  /// entries.
  void add_results(std::span<const golden::Word> results);
  /// Kinds of commands, lengths, changes of kind from one command to the next.
  void add_stream(std::span<const golden::Word> stream, const golden::HardwareConfig& config);
  /// Where cycles went.
  void add_cycles(const golden::Counters& counters);

  const std::map<std::string, std::uint64_t>& counts() const { return counts_; }

 private:
  void add_sticky(std::uint32_t sticky);
  void expect(const std::string& bin) { counts_.try_emplace(bin, 0); }
  void count(const std::string& bin) { ++counts_[bin]; }

  std::map<std::string, std::uint64_t> counts_;
};

}  // namespace gnomon::sim::test
