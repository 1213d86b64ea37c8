// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/run_stream.hpp"

#include <algorithm>
#include <gnomon/golden/golden_engine.hpp>

namespace gnomon::golden_test {

using golden::Word;

std::vector<Word> drain(golden::Engine& engine) {
  std::vector<Word> results;
  engine.drain(
      [&](std::span<const Word> words) { results.insert(results.end(), words.begin(), words.end()); });
  return results;
}

Outcome run(const golden::HardwareConfig& config, std::span<const Word> words, std::size_t piece) {
  const auto engine = golden::make_golden_engine(config);
  while (!words.empty()) {
    const auto part = words.first(piece == 0 ? words.size() : std::min(piece, words.size()));
    engine->submit(part);
    words = words.subspan(part.size());
  }
  Outcome outcome;
  outcome.results = drain(*engine);
  outcome.events = engine->counters().events;
  outcome.plane = engine->read_plane();
  return outcome;
}

Comparison compare(std::span<const Word> expected, std::span<const Word> actual) {
  Comparison result;
  result.compared = std::min(expected.size(), actual.size());
  const auto note = [&](std::size_t at, const std::string& what) {
    if (++result.differ == 1) result.first = "word " + std::to_string(at) + ": " + what;
  };
  for (std::size_t i = 0; i < result.compared; ++i) {
    if (expected[i] == actual[i]) continue;
    note(i,
         "expected " + golden::describe_result(expected[i]) + ", got " + golden::describe_result(actual[i]));
  }
  for (std::size_t i = result.compared; i < expected.size(); ++i) note(i, "missing");
  for (std::size_t i = result.compared; i < actual.size(); ++i) note(i, "surplus");
  return result;
}

std::vector<Word> command(const golden::Header& header, std::vector<Word> items) {
  items.insert(items.begin(), golden::encode(header));
  return items;
}

std::vector<Word> operator+(std::vector<Word> a, const std::vector<Word>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace gnomon::golden_test
