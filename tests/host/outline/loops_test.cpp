// SPDX-License-Identifier: Apache-2.0
// Balanced arcs fall into loops; unbalanced ones are noticed.
#include "host/outline/loops.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace gnomon::outline {
namespace {

ArcGraph graph_of(std::uint32_t points, const std::vector<ArcGraph::Arc>& arcs) {
  ArcGraph graph;
  for (std::uint32_t i = 0; i < points; ++i) graph.add({double(i), double(i) * i, 0});
  for (const auto& [a, b] : arcs) graph.add(a, b, 1);
  return graph;
}

TEST(Loops, UseEveryArcOnceAndNoPointTwice) {
  std::mt19937 random(3);
  std::uniform_int_distribution<std::uint32_t> point(0, 11);
  std::size_t arcs = 0;
  for (int round = 0; round < 100; ++round) {
    ArcGraph graph = graph_of(12, {});
    for (int cycle = 0; cycle < 6; ++cycle) {
      std::uint32_t first = point(random);
      std::uint32_t at = first;
      for (int i = 0; i < 5; ++i) {
        const std::uint32_t next = point(random);
        graph.add(at, next, 1);
        at = next;
      }
      graph.add(at, first, 1);
    }
    std::vector<ArcGraph::Arc> used;
    for (const Loop& loop : link_loops(graph)) {
      std::vector<int> seen(12, 0);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto a = static_cast<std::uint32_t>(loop[i].x);
        used.emplace_back(a, static_cast<std::uint32_t>(loop[(i + 1) % loop.size()].x));
        EXPECT_EQ(seen[a]++, 0);
      }
    }
    std::vector<ArcGraph::Arc> expected = graph.arcs;
    std::sort(expected.begin(), expected.end());
    std::sort(used.begin(), used.end());
    EXPECT_EQ(used, expected);
    arcs += used.size();
  }
  EXPECT_GT(arcs, 2000U);
}

TEST(Loops, ArcsAreSentAsOftenAsTheyAddUpTo) {
  ArcGraph graph = graph_of(3, {});
  graph.add(0, 1, 2);
  graph.add(2, 1, -2);
  graph.add(2, 0, 2);
  graph.add(1, 1, 5);
  EXPECT_EQ(link_loops(graph).size(), 2U);
}

TEST(Loops, NoticeArcsThatDoNotClose) {
  EXPECT_THROW(link_loops(graph_of(3, {{0, 1}, {1, 2}})), std::logic_error);
  EXPECT_THROW(link_loops(graph_of(4, {{0, 1}, {1, 0}, {1, 3}})), std::logic_error);
}

}  // namespace
}  // namespace gnomon::outline
