// SPDX-License-Identifier: Apache-2.0
// Golden's chains and crossings, and how they are compared.
#include "tests/rtl/slb/outline/outcome.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon::rtl_test::slb {

using golden::slb::Chain;
using golden::slb::FragmentOp;

std::ostream& operator<<(std::ostream& stream, const ChainRecord& chain) {
  return stream << "chain (" << chain.column << ", " << chain.row << ") op " << chain.op << std::hex
                << " a 0x" << chain.a << " b 0x" << chain.b << std::dec << " corner " << chain.corner
                << " depth " << chain.depth;
}
std::ostream& operator<<(std::ostream& stream, const WindRecord& wind) {
  return stream << "crossing of y = " << wind.row << " in column " << wind.column
                << (wind.up ? " up" : " down");
}
std::ostream& operator<<(std::ostream& stream, const Counts& counts) {
  return stream << counts.vertices << " vertices, " << counts.repeated << " repeated, " << counts.loops
                << " loops, " << counts.shorts << " short, " << counts.tinies << " tiny, area "
                << counts.tiny_area2 << ", " << counts.crossings << " crossings";
}

namespace {

/// Golden, writing down what it sends.
golden::slb::ChainBuilder recording_builder(Outcome& outcome, const SlbConfig& config) {
  const auto on_chain = [&outcome, config](const Chain& chain) {
    outcome.chains.push_back({.column = chain.column,
                              .row = chain.row,
                              .op = static_cast<unsigned>(chain.op),
                              .a = pack(chain.a, config),
                              .b = chain.op == FragmentOp::One ? 0 : pack(chain.b, config),
                              .corner = chain.holds_corner,
                              .depth = chain.depth});
  };
  const auto on_winding = [&outcome](std::int64_t column, std::int64_t row, bool up) {
    outcome.winds.push_back({column, row, up});
  };
  return {config, on_chain, on_winding};
}

}  // namespace

Outcome expected_so_far(std::span<const Vertex> vertices, const SlbConfig& config) {
  Outcome outcome;
  golden::slb::ChainBuilder builder = recording_builder(outcome, config);
  for (const Vertex& vertex : vertices) builder.vertex(vertex);
  outcome.counts = {
      .vertices = vertices.size(), .repeated = builder.repeated(), .crossings = builder.crossings()};
  return outcome;
}

Outcome expected(std::span<const Loop> loops, const SlbConfig& config) {
  Outcome outcome;
  golden::slb::ChainBuilder builder = recording_builder(outcome, config);
  Counts& counts = outcome.counts;
  for (const Loop& loop : loops) {
    for (const Vertex& vertex : loop) builder.vertex(vertex);
    const golden::slb::LoopSummary summary = builder.close();
    counts.vertices += loop.size();
    counts.repeated += summary.repeated;
    counts.crossings += summary.crossings;
    ++counts.loops;
    if (summary.too_short) ++counts.shorts;
    if (summary.tiny) ++counts.tinies;
    counts.tiny_area2 += summary.tiny_area2;
  }
  return outcome;
}

namespace {

template <class Record>
void compare_records(const std::vector<Record>& hardware, const std::vector<Record>& golden) {
  const auto [theirs, ours] = std::mismatch(hardware.begin(), hardware.end(), golden.begin(), golden.end());
  const auto index = theirs - hardware.begin();
  if (theirs != hardware.end() && ours != golden.end()) {
    ADD_FAILURE() << "record " << index << "\n  hardware: " << *theirs << "\n  golden:   " << *ours;
  }
  EXPECT_EQ(hardware.size(), golden.size());
}

}  // namespace

std::size_t compare(const Outcome& hardware, const Outcome& golden) {
  compare_records(hardware.chains, golden.chains);
  compare_records(hardware.winds, golden.winds);
  EXPECT_EQ(hardware.counts, golden.counts);
  return golden.chains.size() + golden.winds.size();
}

bool same(const Outcome& hardware, const Outcome& golden) {
  return hardware.chains == golden.chains && hardware.winds == golden.winds &&
         hardware.counts == golden.counts;
}

}  // namespace gnomon::rtl_test::slb
