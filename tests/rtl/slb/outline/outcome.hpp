// SPDX-License-Identifier: Apache-2.0
// What the front end of the silhouette-line buffer makes of loops: golden's answer, in a form that hardware
// can be compared with.
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/chain_builder.hpp>
#include <ostream>
#include <span>
#include <vector>

namespace gnomon::rtl_test::slb {

using golden::slb::SlbConfig;
using golden::slb::Vertex;

/// The vertices of one loop, as they are sent.
using Loop = std::vector<Vertex>;

struct ChainRecord {
  std::int64_t column = 0, row = 0;
  unsigned op = 0;
  std::uint32_t a = 0, b = 0;  ///< packed lines
  bool corner = false;
  std::uint32_t depth = 0;
  bool operator==(const ChainRecord&) const = default;
};
std::ostream& operator<<(std::ostream& stream, const ChainRecord& chain);

struct WindRecord {
  std::int64_t column = 0, row = 0;
  bool up = false;
  bool operator==(const WindRecord&) const = default;
};
std::ostream& operator<<(std::ostream& stream, const WindRecord& wind);

/// Event counters of docs/slb.md that the front end feeds.
struct Counts {
  std::uint64_t vertices = 0, repeated = 0, loops = 0, shorts = 0, tinies = 0, tiny_area2 = 0, crossings = 0;
  bool operator==(const Counts&) const = default;
};
std::ostream& operator<<(std::ostream& stream, const Counts& counts);

struct Outcome {
  std::vector<ChainRecord> chains;
  std::vector<WindRecord> winds;
  Counts counts;
};

/// Golden's answer.
Outcome expected(std::span<const Loop> loops, const SlbConfig& config);

/// What golden has sent for the first vertices of a loop that is not closed yet.
Outcome expected_so_far(std::span<const Vertex> vertices, const SlbConfig& config);

/// Fails the running test, once, where the two differ first; returns the number of records compared.
std::size_t compare(const Outcome& hardware, const Outcome& golden);

/// Whether they are the same, without failing anything.
bool same(const Outcome& hardware, const Outcome& golden);

}  // namespace gnomon::rtl_test::slb
