// SPDX-License-Identifier: Apache-2.0
// From the last stage to the first: what leaves makes room for what is behind it.
#include "slb_draw.hpp"

#include <algorithm>
#include <cstdlib>

namespace gnomon::golden::cycles {
namespace {

constexpr std::size_t kSlots = 32, kChains = 16;
constexpr Cycle kAreaStages = 3;    // a vertex or an end, until the loop's area is up to date
constexpr Cycle kStepStages = 7;    // a step, until the line encoders are empty
constexpr Cycle kChainStages = 11;  // a crossing, until its chain is at the end of the queue
constexpr Cycle kWindStages = 3;    // a crossing of y = j, until its change is in the memory; and the latency

bool same_point(const slb::Vertex& a, const slb::Vertex& b) {
  return a.x == b.x && a.y == b.y;
}

std::uint64_t borders(const slb::Vertex& a, const slb::Vertex& b, const slb::SlbConfig& config) {
  const auto apart = [&](std::int64_t from, std::int64_t to) {
    return std::abs((to >> config.subpixel_bits) - (from >> config.subpixel_bits));
  };
  return static_cast<std::uint64_t>(apart(a.x, b.x) + apart(a.y, b.y));
}

}  // namespace

DrawClock::DrawClock(const slb::SlbConfig& config, const HardwareTiming& timing)
    : config_(config),
      latency_(static_cast<Cycle>(timing.memory_latency)),
      dividers_(timing.slb_dividers),
      divider_stages_(
          static_cast<Cycle>(std::max(config.frac_bits + config.subpixel_bits, config.depth_bits))) {}

SlbMoves DrawClock::cycle(const Offer* offer, SlbMemory& memory, Ports& ports) {
  const Cycle now = ports.now();
  const std::size_t slots = slots_;
  SlbMoves moves;
  memory.begin(ports);
  const bool walker_free = walk(now, moves);
  move_chains(memory, now, moves);
  move_stages(walker_free, now);
  leave_loop(slots < kSlots, now);
  moves.taken = offer != nullptr && !stages_[Loop] && take(*offer, now);
  if (!stages_[Loop] && second_) {
    stages_[Loop] = second_;
    stages_[Loop]->from_cycle = now + 1;
    second_.reset();
  }
  memory.serve(ports);
  return moves;
}

/// Chains go to the memory through a register; those off the plane end before it.
void DrawClock::move_chains(SlbMemory& memory, Cycle now, SlbMoves& moves) {
  moves.waits = chain_ && !memory.free();
  if (moves.waits) return;
  if (chain_) memory.take({.index = *chain_, .kind = SlbRequest::Kind::Chain});
  chain_.reset();
  if (chains_.empty() || chains_.front().there > now) return;
  chain_ = chains_.front().index;
  drained_ = std::max(drained_, now + 1);
  chains_.pop_front();
  --under_way_;
}

/// A step, while fewer chains are under way than the queue holds. Returns whether the next edge may come.
bool DrawClock::walk(Cycle now, SlbMoves& moves) {
  if (steps_ == 0) return true;
  if (under_way_ >= kChains) return false;
  drained_ = std::max(drained_, now + kStepStages);
  if (walked_.crossings != 0) {
    moves.steps = true;
    cross(now);
  }
  if (--steps_ != 0) return false;
  if (walked_.last && entered_)
    chains_.push_back({now + kChainStages + 1, pixel_on_plane(walked_.to.x >> config_.subpixel_bits,
                                                              walked_.to.y >> config_.subpixel_bits)});
  return true;
}

/// The chain of the pixel that is left is finished, but for the loop's first one, which waits for the end.
void DrawClock::cross(Cycle now) {
  const slb::Side side = walker_->exit_side();
  const std::int64_t column = walker_->column(), row = walker_->row();
  if (entered_) chains_.push_back({now + kChainStages, pixel_on_plane(column, row)});
  entered_ = true;
  ++under_way_;
  const bool rises = side == slb::Side::Top;
  const std::int64_t border = row + (rises ? 1 : 0);
  if ((rises || side == slb::Side::Bottom) && border >= 0 && border < config_.side() &&
      column < config_.side())
    drained_ = std::max(drained_, now + kWindStages + latency_);
  walker_->cross();
}

std::optional<std::uint32_t> DrawClock::pixel_on_plane(std::int64_t column, std::int64_t row) const {
  const auto on = [&](std::int64_t index) { return index >= 0 && index < config_.side(); };
  if (!on(column) || !on(row)) return std::nullopt;
  return static_cast<std::uint32_t>(row << config_.plane_log2 | column);
}

void DrawClock::begin_walk(const Edge& edge) {
  if (edge.first) entered_ = false;
  walked_ = edge;
  steps_ = std::max<std::uint64_t>(1, edge.crossings);
  if (edge.crossings != 0) walker_.emplace(edge.from, edge.to, config_);
}

/// From the walker back to the second register.
void DrawClock::move_stages(bool walker_free, Cycle now) {
  if (walker_free && stages_[Place]) {
    begin_walk(*stages_[Place]);
    stages_[Place].reset();
  }
  pass_on(Quotients, now);
  if (!ring_.empty() && !stages_[Quotients] && ring_.front().from_cycle <= now) {
    stages_[Quotients] = ring_.front();
    ring_.pop_front();
    --slots_;
  }
  if (stages_[Issue] && stages_[Issue]->from_cycle <= now) {
    ring_.push_back(*stages_[Issue]);
    ring_.back().from_cycle = now + divider_stages_ + 1;
    stages_[Issue].reset();
    issued_ = now;
  }
  if (stages_[Product] && !stages_[Issue]) {
    const Cycle until = issue(*stages_[Product], now);
    pass_on(Product, now);
    stages_[Issue]->from_cycle = until;
  }
  pass_on(Differences, now);
}

/// To the next stage, if that is empty. What comes there in a cycle leaves it in a later one.
bool DrawClock::pass_on(Stage stage, Cycle now) {
  std::optional<Edge>& next = stages_.at(stage + 1U);
  if (!stages_.at(stage) || next) return false;
  next = stages_.at(stage);
  next->from_cycle = now + 1;
  stages_.at(stage).reset();
  return true;
}

/// The last cycle at issue. The first quotient may have gone along with the edge before.
Cycle DrawClock::issue(const Edge& edge, Cycle now) {
  const bool joined = joins_ && edge.quotients != 0 && edge.from_cycle <= issued_;
  const int left = edge.quotients - (joined ? 1 : 0);
  const int cycles = std::max(1, (left + dividers_ - 1) / dividers_);
  joins_ = dividers_ == 2 && left - (cycles - 1) * dividers_ <= 1;
  return now + static_cast<Cycle>(cycles);
}

/// An edge inside one pixel goes along with the next one, unless it is its loop's last.
void DrawClock::leave_loop(bool slot, Cycle now) {
  std::optional<Edge>& edge = stages_[Loop];
  if (!edge || edge->from_cycle > now) return;
  if (edge->quotients == 0 && !edge->last) {
    edge.reset();
    return;
  }
  edge->first = fresh_;
  if (!slot || !pass_on(Loop, now)) return;
  fresh_ = false;
  ++slots_;
}

DrawClock::Edge DrawClock::edge(const slb::Vertex& from, const slb::Vertex& to, bool last,
                                Cycle cycle) const {
  Edge edge{
      .from = from, .to = to, .crossings = borders(from, to, config_), .last = last, .from_cycle = cycle};
  if (edge.crossings == 0) return edge;
  const std::int64_t longer = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  edge.quotients = longer > config_.subpixels() && from.depth != to.depth ? 3 : 2;
  return edge;
}

bool DrawClock::take(const Offer& offer, Cycle now) {
  if (second_) return false;
  if (!offer.closes) {
    take_vertex(offer.vertex, now);
    return true;
  }
  drained_ = std::max(drained_, now + kAreaStages);
  if (count_ == 3) stages_[Loop] = edge(last_, origin_, true, now + 1);
  count_ = 0;
  return true;
}

void DrawClock::take_vertex(const slb::Vertex& vertex, Cycle now) {
  if (count_ != 0 && same_point(vertex, last_)) return;
  if (count_ == 0) {
    origin_ = vertex;
    in_pixel_ = true;
  }
  in_pixel_ = in_pixel_ && borders(vertex, origin_, config_) == 0;
  if (in_pixel_ && count_ != 0) drained_ = std::max(drained_, now + kAreaStages);
  if (count_ == 2) {  // the third vertex brings two edges
    fresh_ = true;
    stages_[Loop] = edge(origin_, last_, false, now + 1);
    second_ = edge(last_, vertex, false, now + 1);
  } else if (count_ == 3) {
    stages_[Loop] = edge(last_, vertex, false, now + 1);
  }
  last_ = vertex;
  count_ = std::min(count_ + 1, 3);
}

bool DrawClock::idle(Cycle now) const {
  return now >= drained_ && !chain_ && chains_.empty() && steps_ == 0 && ring_.empty() && !second_ &&
         std::ranges::none_of(stages_, [](const auto& stage) { return stage.has_value(); });
}

}  // namespace gnomon::golden::cycles
