// SPDX-License-Identifier: Apache-2.0
// Topological order with a stack: what a quad was the last to hold back comes next.
#include "host/plan/quad_order.hpp"

#include <algorithm>

namespace gnomon::plan {
namespace {

template <class Visit>
void for_each_entry(const LinkedBox& box, std::uint32_t side, Visit visit) {
  for (std::uint32_t v = box.v; v < box.v + box.rows; ++v)
    for (std::uint32_t u = box.u; u < box.u + box.columns; ++u) visit(std::size_t{v} * side + u);
}

/// The quads of each entry, one entry behind the other.
struct Lists {
  std::vector<std::uint32_t> ends;   ///< of each entry's quads
  std::vector<std::uint32_t> next;   ///< ... its first one that is still to come
  std::vector<std::uint32_t> quads;  ///< in their order
};

Lists lists_of(std::span<const LinkedBox> boxes, std::uint32_t side) {
  Lists lists;
  lists.ends.assign(std::size_t{side} * side, 0);
  for (const LinkedBox& box : boxes) for_each_entry(box, side, [&](std::size_t e) { ++lists.ends[e]; });
  lists.next.resize(lists.ends.size());
  std::uint32_t end = 0;
  for (std::size_t e = 0; e < lists.ends.size(); ++e) {
    lists.next[e] = end;
    end += lists.ends[e];
    lists.ends[e] = end;
  }
  lists.quads.resize(end);
  std::vector<std::uint32_t> place = lists.next;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for_each_entry(boxes[i], side, [&](std::size_t e) { lists.quads[place[e]++] = i; });
  return lists;
}

}  // namespace

std::vector<std::uint32_t> depth_first(std::span<const LinkedBox> boxes, std::uint32_t side) {
  Lists lists = lists_of(boxes, side);
  std::vector<std::uint32_t> order;
  order.reserve(boxes.size());
  std::vector<std::uint32_t> held(boxes.size());  // entries in which another one comes before it
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    held[i] = boxes[i].columns * boxes[i].rows;
    if (held[i] == 0) order.push_back(i);
  }
  std::vector<std::uint32_t> ready;
  const auto release = [&](std::size_t e) {
    if (lists.next[e] == lists.ends[e]) return;
    const std::uint32_t quad = lists.quads[lists.next[e]++];
    if (--held[quad] == 0) ready.push_back(quad);
  };
  for (std::size_t e = 0; e < lists.ends.size(); ++e) release(e);
  std::ranges::reverse(ready);
  while (!ready.empty()) {
    const std::uint32_t quad = ready.back();
    ready.pop_back();
    order.push_back(quad);
    for_each_entry(boxes[quad], side, release);
  }
  return order;
}

}  // namespace gnomon::plan
