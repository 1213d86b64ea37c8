// SPDX-License-Identifier: Apache-2.0
// The random streams must reach what they are meant to reach, in every configuration.
#include "tests/golden/slb/stimulus.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace gnomon::golden::slb::testing {
namespace {

/// Legal random widths; items fit their words.
SlbConfig random_config(Random& random) {
  for (;;) {
    SlbConfig config;
    config.frac_bits = static_cast<int>(random.integer(3, 8));
    config.slope_bits = static_cast<int>(random.integer(3, 9));
    config.frags = static_cast<int>(random.integer(1, 4));
    config.depth_bits = static_cast<int>(random.integer(8, 24));
    config.plane_log2 = static_cast<int>(random.integer(3, 5));
    config.subpixel_bits = static_cast<int>(random.integer(config.frac_bits + 3, 14));
    config.query_bits = static_cast<int>(random.integer(config.frac_bits + 3, 14));
    config.rounding = random.integer(0, 3) == 0 ? Rounding::Published : Rounding::Better;
    if (!config.check() && !check_items(config)) return config;
  }
}

struct Bins {
  std::set<unsigned> lines;                      ///< major, xsign, cross, inner
  std::set<std::pair<FragmentOp, bool>> groups;  ///< op, cont
  std::set<int> thresholds;
  std::map<SlbError, int> errors;
  std::map<std::uint8_t, int> ops;
  std::set<QueryAnswer, bool (*)(const QueryAnswer&, const QueryAnswer&)> answers{
      [](const QueryAnswer& a, const QueryAnswer& b) { return encode(a, 0) < encode(b, 0); }};
  SlbCounters counters;
};

void collect(const SlbModel& model, Bins& bins) {
  for (int row = 0; row < model.config().side(); ++row)
    for (int column = 0; column < model.config().side(); ++column) {
      const Entry entry = model.entry(column, row);
      for (int i = 0; i < entry.count; ++i) {
        const Fragment& fragment = entry.fragments[static_cast<std::size_t>(i)];
        bins.groups.insert({fragment.op, fragment.cont});
        if (!fragment.cont) bins.thresholds.insert(fragment.threshold_m1 + 1);
        const auto add = [&](const Line& line) {
          bins.lines.insert(pack(line, model.config()) >>
                            (model.config().frac_bits + model.config().slope_bits));
        };
        add(fragment.a);
        if (fragment.op != FragmentOp::One) add(fragment.b);
      }
    }
}

TEST(Stimulus, ReachesEveryBin) {
  Bins bins;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const SlbConfig config = random_config(random);
    SlbUnit unit(config);
    for (const Command& command : random_commands(seed, config)) {
      const SlbOutcome outcome = unit.execute(command.op, command.flags, command.arg, command.items);
      ++bins.errors[outcome.error];
      if (outcome.error != SlbError::None) continue;
      ++bins.ops[command.op];
      if (command.op != static_cast<std::uint8_t>(SlbOp::Query)) continue;
      for (const Word word : outcome.results) {
        QueryAnswer answer = decode_answer(word);
        answer.object = 0;
        bins.answers.insert(answer);
      }
    }
    collect(unit.model(), bins);
    const SlbCounters& c = unit.model().counters();
    bins.counters.chains_dropped += c.chains_dropped;
    bins.counters.chains_reduced += c.chains_reduced;
    bins.counters.groups_evicted += c.groups_evicted;
    bins.counters.loops_short += c.loops_short;
    bins.counters.loops_tiny += c.loops_tiny;
    bins.counters.chains_off_plane += c.chains_off_plane;
    bins.counters.covers_used += c.covers_used;
    bins.counters.queries_off_plane += c.queries_off_plane;
  }
  EXPECT_EQ(bins.lines.size(), 16u) << "major, xsign, cross and inner in every combination";
  EXPECT_EQ(bins.groups.size(), 8u) << "every op, first and continued";
  EXPECT_GE(bins.thresholds.size(), 4u);
  EXPECT_EQ(bins.ops.size(), 8u);
  for (const SlbError error : {SlbError::BadArgument, SlbError::ReservedFlag, SlbError::BadSequence})
    EXPECT_GT(bins.errors[error], 5) << "error " << static_cast<int>(error);
  // shadow by full, by lines, by both, none; with and without fragments and overflow; off the plane.
  EXPECT_GE(bins.answers.size(), 10u);
  EXPECT_GT(bins.counters.chains_dropped, 100u);
  EXPECT_GT(bins.counters.chains_reduced, 20u);
  EXPECT_GT(bins.counters.groups_evicted, 20u);
  EXPECT_GT(bins.counters.loops_short, 20u);
  EXPECT_GT(bins.counters.loops_tiny, 5u);
  EXPECT_GT(bins.counters.chains_off_plane, 1000u);
  EXPECT_GT(bins.counters.covers_used, 100u);
  EXPECT_GT(bins.counters.queries_off_plane, 100u);
}

TEST(Stimulus, SameSeedSameWords) {
  const SlbConfig config = slb4();
  EXPECT_EQ(to_words(random_commands(5, config)), to_words(random_commands(5, config)));
  EXPECT_NE(to_words(random_commands(5, config)), to_words(random_commands(6, config)));
  const std::vector<Command> commands = random_commands(5, config);
  std::size_t words = 0;
  for (const Command& c : commands) words += 1 + c.items.size();
  EXPECT_EQ(to_words(commands).size(), words);
}

}  // namespace
}  // namespace gnomon::golden::slb::testing
