// SPDX-License-Identifier: Apache-2.0
// Walks along unused arcs, cut off whenever they meet themselves.
#include "host/outline/loops.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace gnomon::outline {
namespace {

class Linker {
 public:
  explicit Linker(const ArcGraph& graph) : graph_(graph), place_(graph.points.size(), kNowhere) {
    // Arcs by where they begin; of each point the next unused one.
    first_.assign(graph.points.size() + 1, 0);
    for (const auto& [a, b] : graph.arcs) ++first_[a + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    target_.resize(graph.arcs.size());
    std::vector<std::size_t> fill(first_.begin(), first_.end() - 1);
    for (const auto& [a, b] : graph.arcs) target_[fill[a]++] = b;
    next_.assign(first_.begin(), first_.end() - 1);
  }

  std::vector<Loop> run() {
    for (std::uint32_t start = 0; start < graph_.points.size(); ++start)
      while (next_[start] < first_[start + 1]) walk(start);
    return std::move(loops_);
  }

 private:
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

  void walk(std::uint32_t start) {
    std::uint32_t at = start;
    for (;;) {
      if (place_[at] != kNowhere) cut_loop(place_[at]);
      place_[at] = path_.size();
      path_.push_back(at);
      if (next_[at] == first_[at + 1]) break;
      at = target_[next_[at]++];
    }
    if (path_.size() != 1) throw std::logic_error("outline: an arc leads to a point that no arc leaves");
    place_[start] = kNowhere;
    path_.clear();
  }

  /// The path from `begin` on is a loop: its end meets its start.
  void cut_loop(std::size_t begin) {
    Loop loop;
    loop.reserve(path_.size() - begin);
    for (std::size_t i = begin; i < path_.size(); ++i) {
      loop.push_back(graph_.points[path_[i]]);
      place_[path_[i]] = kNowhere;
    }
    path_.resize(begin);
    loops_.push_back(std::move(loop));
  }

  const ArcGraph& graph_;
  std::vector<std::size_t> first_, next_;
  std::vector<std::uint32_t> target_;
  std::vector<std::size_t> place_;  // of a point in the path
  std::vector<std::uint32_t> path_;
  std::vector<Loop> loops_;
};

}  // namespace

void ArcGraph::add(std::uint32_t a, std::uint32_t b, int times) {
  if (a == b) return;
  for (; times > 0; --times) arcs.emplace_back(a, b);
  for (; times < 0; ++times) arcs.emplace_back(b, a);
}

std::vector<Loop> link_loops(const ArcGraph& graph) {
  return Linker(graph).run();
}

}  // namespace gnomon::outline
