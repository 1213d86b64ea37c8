// SPDX-License-Identifier: Apache-2.0
// Small helpers around a golden engine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gnomon::golden_test {

/// All results the engine has not given yet.
std::vector<golden::Word> drain(golden::Engine& engine);

struct Outcome {
  std::vector<golden::Word> results;
  std::map<std::string, std::uint64_t> events;
  std::vector<std::uint32_t> plane;
  bool operator==(const Outcome&) const = default;
};

/// A new engine, the words submitted in pieces of `piece` words (0: all at once), one drain at the end.
Outcome run(const golden::HardwareConfig& config, std::span<const golden::Word> words, std::size_t piece = 0);

/// How many words differ; each missing or surplus word counts. `first` describes the first pair.
struct Comparison {
  std::size_t compared = 0, differ = 0;
  std::string first;
};
Comparison compare(std::span<const golden::Word> expected, std::span<const golden::Word> actual);

/// The command stream of one header and its items.
std::vector<golden::Word> command(const golden::Header& header, std::vector<golden::Word> items = {});

/// Concatenation.
std::vector<golden::Word> operator+(std::vector<golden::Word> a, const std::vector<golden::Word>& b);

}  // namespace gnomon::golden_test
