// SPDX-License-Identifier: Apache-2.0
// One line of recurrence a stage: an edge leaves it when it has been there for a cycle and the stage behind
// is free.
#include "outline.hpp"

#include <algorithm>
#include <cstdlib>
#include <gnomon/golden/slb/edge_walker.hpp>

namespace gnomon::golden::cycles {
namespace {

constexpr Cycle kAreaStages = 3;     // a vertex or an end, until the loop's area is up to date
constexpr Cycle kStepStages = 7;     // a step, until the line encoders are empty
constexpr Cycle kChainStages = 12;   // a crossing, until its chain has left the queue
constexpr Cycle kInsertStages = 14;  // a crossing, until its chain is in the memory; and the latency
constexpr Cycle kWindStages = 3;  // a crossing of y = j, until its change is in the memory; and the latency

std::int64_t pixel(std::int64_t coordinate, const slb::SlbConfig& config) {
  return coordinate >> config.subpixel_bits;
}

bool same_point(const slb::Vertex& a, const slb::Vertex& b) {
  return a.x == b.x && a.y == b.y;
}

bool same_pixel(const slb::Vertex& a, const slb::Vertex& b, const slb::SlbConfig& config) {
  return pixel(a.x, config) == pixel(b.x, config) && pixel(a.y, config) == pixel(b.y, config);
}

std::uint64_t borders(const slb::Vertex& a, const slb::Vertex& b, const slb::SlbConfig& config) {
  return static_cast<std::uint64_t>(std::abs(pixel(b.x, config) - pixel(a.x, config)) +
                                    std::abs(pixel(b.y, config) - pixel(a.y, config)));
}

}  // namespace

Outline::Outline(const slb::SlbConfig& config, const HardwareTiming& timing)
    : config_(config),
      latency_(timing.memory_latency),
      dividers_(timing.slb_dividers),
      divider_stages_(std::max(config.frac_bits + config.subpixel_bits, config.depth_bits)) {}

Cycle Outline::vertex(const slb::Vertex& vertex, Cycle earliest, Run& run) {
  const Cycle taken = take(earliest);
  loop_free_ = std::max(loop_free_, taken);
  if (count_ != 0 && same_point(vertex, last_)) return taken;
  if (count_ == 0) {
    origin_ = vertex;
    in_pixel_ = true;
    left_pixel_ = false;
  } else {
    in_pixel_ = in_pixel_ && same_pixel(vertex, origin_, config_);
    if (in_pixel_) drained_ = std::max(drained_, taken + kAreaStages);
  }
  before_ = last_;
  last_ = vertex;
  if (count_ == 2) {  // the third vertex brings two edges
    edge(origin_, before_, taken + 1, false, run);
    edge(before_, last_, loop_free_ + 1, false, run);
  } else if (count_ == 3) {
    edge(before_, last_, taken + 1, false, run);
  }
  count_ = std::min(count_ + 1, 3);
  return taken;
}

Cycle Outline::close(Cycle earliest, Run& run) {
  const Cycle taken = take(earliest);
  loop_free_ = std::max(loop_free_, taken);
  drained_ = std::max(drained_, taken + kAreaStages);
  if (count_ == 3) edge(last_, origin_, taken + 1, true, run);
  count_ = 0;
  return taken;
}

int Outline::quotients(const slb::Vertex& from, const slb::Vertex& to) const {
  if (same_pixel(from, to, config_)) return 0;
  const std::int64_t den = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  return den > config_.subpixels() && from.depth != to.depth ? 3 : 2;
}

/// The last cycle at issue of an edge that is in the product's register from `in_product` on.
Cycle Outline::issue(int wanted, bool asks_first, Cycle in_product) {
  const bool joined = ahead_.joins && asks_first && in_product <= ahead_.issue;
  const int left = wanted - (joined ? 1 : 0);
  const int cycles = std::max(1, (left + dividers_ - 1) / dividers_);
  const int in_last_cycle = left - (cycles - 1) * dividers_;
  ahead_.joins = dividers_ == 2 && in_last_cycle <= 1;
  return ahead_.product + static_cast<Cycle>(cycles);
}

void Outline::edge(const slb::Vertex& from, const slb::Vertex& to, Cycle cycle, bool last, Run& run) {
  const int wanted = quotients(from, to);
  if (wanted == 0 && !last) {  // folded into the next edge: it leaves at once
    loop_free_ = cycle;
    return;
  }
  const std::size_t slot = edges_ % kSlots;
  const Cycle slot_free = edges_ < kSlots ? 0 : slots_[slot] + 1;
  ++edges_;

  Stages& s = ahead_;  // of the edge before until overwritten
  s.loop = std::max({cycle, s.delta, slot_free});
  s.delta = std::max(s.loop + 1, s.product);
  const Cycle in_product = s.delta + 1;
  s.product = std::max(in_product, s.issue);
  s.issue = issue(wanted, wanted != 0, in_product);
  s.slot = std::max(s.issue + static_cast<Cycle>(divider_stages_) + 1, s.quotients);
  s.quotients = std::max(s.slot + 1, s.place);
  s.place = std::max(s.quotients + 1, s.walked);
  const std::uint64_t crossings = borders(from, to, config_);
  const Cycle first_step = s.place + 1;
  s.walked = s.place + std::max<std::uint64_t>(1, crossings);
  slots_[slot] = s.slot;
  loop_free_ = s.loop;

  run.step(first_step, crossings);
  walked_.push_back({from, to, first_step, s.walked, !left_pixel_, crossings != 0, last && left_pixel_});
  left_pixel_ = left_pixel_ || crossings != 0;
  forget_old();
}

/// Chains that were finished so long before the last step do not decide when the unit is drained.
void Outline::forget_old() {
  const Cycle window = static_cast<Cycle>(latency_) + kInsertStages;
  while (walked_.size() > 1 && walked_.front().last_step + window < walked_.back().last_step)
    walked_.pop_front();
}

/// From when on the chains and changes of the winding number that an edge's crossings bring are stored.
Cycle Outline::chain_drained(const Walked& edge) const {
  const auto latency = static_cast<Cycle>(latency_);
  const auto on = [&](std::int64_t index) { return index >= 0 && index < config_.side(); };
  const auto chain = [&](std::int64_t column, std::int64_t row, Cycle step) {
    return step + (on(column) && on(row) ? kInsertStages + latency : kChainStages);
  };
  Cycle drained = 0;
  bool entered = !edge.inside;
  if (edge.crosses) {
    slb::EdgeWalker walker(edge.from, edge.to, config_);
    for (Cycle step = edge.first_step; !walker.done(); ++step) {
      const slb::Side side = walker.exit_side();
      const std::int64_t column = walker.column(), row = walker.row();
      if (entered) drained = std::max(drained, chain(column, row, step));
      entered = true;
      const bool rises = side == slb::Side::Top;
      if ((rises || side == slb::Side::Bottom) && on(row + (rises ? 1 : 0)) && column < config_.side())
        drained = std::max(drained, step + kWindStages + latency);
      walker.cross();
    }
  }
  if (edge.closes)
    drained =
        std::max(drained, chain(pixel(edge.to.x, config_), pixel(edge.to.y, config_), edge.last_step + 1));
  return drained;
}

Cycle Outline::drained() const {
  Cycle drained = drained_;
  if (walked_.empty()) return drained;
  drained = std::max(drained, walked_.back().last_step + kStepStages);
  for (const Walked& edge : walked_) drained = std::max(drained, chain_drained(edge));
  return drained;
}

}  // namespace gnomon::golden::cycles
