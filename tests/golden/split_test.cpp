// SPDX-License-Identifier: Apache-2.0
// Where a stream is cut into submits changes nothing.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <gnomon/golden/golden_engine.hpp>

#include "tests/golden/run_stream.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::golden_test {
namespace {

using golden::HardwareConfig;
using golden::Word;

/// Results of both parts, drained after each.
Outcome run_in_two(golden::Engine& engine, std::span<const Word> words, std::size_t cut) {
  engine.reset();
  Outcome outcome;
  for (const auto part : {words.first(cut), words.subspan(cut)}) {
    engine.submit(part);
    for (const Word word : drain(engine)) outcome.results.push_back(word);
  }
  outcome.events = engine.counters().events;
  outcome.plane = engine.read_plane();
  return outcome;
}

TEST(Split, AtEveryWord) {
  const HardwareConfig config{.plane_log2 = 5};
  const auto words = stimulus::random_stream(config, {.seed = 11, .commands = 60, .max_items = 12});
  const Outcome whole = run(config, words);
  ASSERT_GT(whole.results.size(), 100u);
  const auto engine = golden::make_golden_engine(config);
  for (std::size_t cut = 0; cut <= words.size(); ++cut) {
    ASSERT_EQ(run_in_two(*engine, words, cut), whole) << "cut at word " << cut << " of " << words.size();
  }
}

TEST(Split, InPiecesOfOneSize) {
  for (HardwareConfig config : stimulus::covering_array()) {
    config.plane_log2 = std::min(config.plane_log2, 9);  // an engine for each size of piece
    const auto words = stimulus::random_stream(config, {.seed = 12, .commands = 40});
    const Outcome whole = run(config, words);
    for (const std::size_t piece : {1u, 2u, 7u, 64u}) {
      const Outcome outcome = run(config, words, piece);
      ASSERT_EQ(compare(whole.results, outcome.results).first, "");
      ASSERT_EQ(outcome.events, whole.events);
    }
  }
}

}  // namespace
}  // namespace gnomon::golden_test
