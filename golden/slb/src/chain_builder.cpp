// SPDX-License-Identifier: Apache-2.0
// Chains of one loop, its winding events and its degenerate cases.
#include <algorithm>
#include <gnomon/golden/slb/chain_builder.hpp>
#include <utility>

namespace gnomon::golden::slb {
namespace {

std::int64_t cross_product(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  return ax * by - ay * bx;
}

/// What a corner between two lines means: the caster on the left of both, or on the left of either.
FragmentOp corner_op(std::int64_t entry_orient, std::int64_t exit_orient, std::int64_t turn, bool same_way) {
  const bool some = entry_orient != 0 || exit_orient != 0;
  if (some && entry_orient >= 0 && exit_orient >= 0) return FragmentOp::And;
  if (some && entry_orient <= 0 && exit_orient <= 0) return FragmentOp::Or;
  if (turn > 0) return FragmentOp::And;
  if (turn < 0) return FragmentOp::Or;
  return same_way ? FragmentOp::One : FragmentOp::And;
}

}  // namespace

ChainBuilder::ChainBuilder(const SlbConfig& config, ChainSink on_chain, WindingSink on_winding)
    : config_(config), on_chain_(std::move(on_chain)), on_winding_(std::move(on_winding)) {}

void ChainBuilder::add_vertex(Partial& chain, const Vertex& vertex) const {
  if (chain.vertices == 0) chain.first = vertex;
  chain.last = vertex;
  chain.vertices = std::min(chain.vertices + 1, 2);
  chain.depth = std::max(chain.depth, vertex.depth);
}

void ChainBuilder::vertex(const Vertex& vertex) {
  if (count_ > 0 && vertex.x == previous_.x && vertex.y == previous_.y) {
    ++repeated_;
    return;
  }
  ++count_;
  if (count_ == 1) {
    origin_ = vertex;
    chain_ = Partial{};
    chain_.column = vertex.x >> config_.subpixel_bits;
    chain_.row = vertex.y >> config_.subpixel_bits;
    add_vertex(chain_, vertex);
  } else if (count_ == 2) {
    pending_ = vertex;  // held back until a third vertex shows that this is a loop
  } else {
    if (count_ == 3) edge(origin_, pending_);
    edge(previous_, vertex);
  }
  previous_ = vertex;
}

LoopSummary ChainBuilder::close() {
  LoopSummary summary;
  summary.vertices = count_;
  summary.too_short = count_ < 3;
  summary.repeated = repeated_;
  if (!summary.too_short) {
    if (previous_.x == origin_.x && previous_.y == origin_.y) {
      ++summary.repeated;
    } else {
      edge(previous_, origin_);
    }
    if (first_exit_) {
      Partial last = chain_;
      // The loop is back in the chain that it began with.
      FirstExit exit = *first_exit_;
      last.vertices = std::min(last.vertices + exit.vertices - 1, 2);
      on_chain_(finish(last, exit));
    } else {
      summary.tiny = true;
      summary.tiny_area2 = static_cast<std::uint64_t>(area2_ < 0 ? -area2_ : area2_);
    }
  }
  summary.crossings = crossings_;
  forget();
  return summary;
}

void ChainBuilder::forget() {
  count_ = repeated_ = crossings_ = 0;
  first_exit_.reset();
  area2_ = 0;
}

void ChainBuilder::edge(const Vertex& from, const Vertex& to) {
  if (!first_exit_)
    area2_ += cross_product(from.x - origin_.x, from.y - origin_.y, to.x - origin_.x, to.y - origin_.y);
  EdgeWalker walker(from, to, config_);
  const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
  while (!walker.done()) {
    const Side side = walker.exit_side();
    chain_.depth = std::max(chain_.depth, walker.depth());
    leave({side, walker.line(), dx, dy, chain_.last, chain_.vertices, chain_.depth});
    const std::int64_t row = walker.row();
    if (side == Side::Top) on_winding_(walker.column(), row + 1, true);
    if (side == Side::Bottom) on_winding_(walker.column(), row, false);
    walker.cross();
    ++crossings_;
    chain_ = Partial{};
    chain_.column = walker.column();
    chain_.row = walker.row();
    chain_.has_entry = true;
    chain_.entry = opposite(side);
    chain_.a = walker.line();
    chain_.entry_dx = dx;
    chain_.entry_dy = dy;
    chain_.depth = walker.depth();
  }
  add_vertex(chain_, to);
}

void ChainBuilder::leave(const FirstExit& exit) {
  if (chain_.has_entry) {
    on_chain_(finish(chain_, exit));
  } else {
    first_exit_ = exit;
  }
}

Chain ChainBuilder::finish(const Partial& chain, const FirstExit& exit) const {
  Chain result;
  result.column = chain.column;
  result.row = chain.row;
  result.a = chain.a;
  result.depth = std::max(chain.depth, exit.depth);
  result.vertices = chain.vertices;
  if (chain.vertices > 0) {
    const std::int64_t span_x = exit.last.x - chain.first.x, span_y = exit.last.y - chain.first.y;
    const std::int64_t entry_orient = cross_product(chain.entry_dx, chain.entry_dy, span_x, span_y);
    const std::int64_t exit_orient = cross_product(exit.dx, exit.dy, -span_x, -span_y);
    const std::int64_t turn = cross_product(chain.entry_dx, chain.entry_dy, exit.dx, exit.dy);
    const bool same_way = chain.entry_dx * exit.dx + chain.entry_dy * exit.dy > 0;
    result.op = corner_op(entry_orient, exit_orient, turn, same_way);
    if (result.op != FragmentOp::One) result.b = exit.b;
  }
  result.holds_corner = chain.entry == exit.exit ? result.op == FragmentOp::Or : exit.exit > chain.entry;
  return result;
}

}  // namespace gnomon::golden::slb
