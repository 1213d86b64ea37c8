// SPDX-License-Identifier: Apache-2.0
// Spans and lines are read ahead; a line's updates go to the memory one a cycle, as it takes them.
#include "slb_fill.hpp"

#include <algorithm>
#include <bit>

namespace gnomon::golden::cycles {
namespace {

constexpr std::size_t kSpanLines = 4;  // or a row, if it has fewer

}  // namespace

FillClock::FillClock(const slb::FillSweep& sweep, bool flat, const slb::SlbConfig& config,
                     const HardwareTiming& timing)
    : side_(config.side()),
      flat_(flat),
      latency_(static_cast<Cycle>(timing.memory_latency)),
      places_(std::bit_ceil(static_cast<std::size_t>(timing.memory_latency) + 3)) {
  const auto row_lines = static_cast<std::size_t>(std::max(1, side_ / slb::kLinePixels));
  const std::size_t span = std::min(kSpanLines, row_lines);
  spans_ = sweep.lines.size() / span;
  for (std::size_t first = 0; first < sweep.lines.size(); first += span) add_span(sweep, first, span);
}

/// The plain lines before its first one with lines go along with that, those behind it up to the next one
/// too.
void FillClock::add_span(const slb::FillSweep& sweep, std::size_t first, std::size_t lines) {
  const std::size_t pixels =
      sweep.lines.empty() ? 0 : std::min<std::size_t>(slb::kLinePixels, static_cast<std::size_t>(side_));
  const auto pixel = [&](std::size_t line) {
    return static_cast<std::uint32_t>(
        static_cast<std::size_t>(sweep.first_row) * static_cast<std::size_t>(side_) + line * pixels);
  };
  const std::size_t end = first + lines;
  std::size_t begun = first;
  do {
    std::size_t own = begun;
    while (own != end && sweep.lines[own].plain()) ++own;
    std::size_t behind = own == end ? end : own + 1;
    while (behind != end && sweep.lines[behind].plain()) ++behind;
    const std::size_t updates = updates_.size();
    if (own != end) add_line(pixel(own), sweep.lines[own]);
    for (std::size_t line = begun; line != behind; ++line) add_plain(pixel(line), sweep.lines[line]);
    begun = behind;
    steps_.push_back({updates, updates_.size(), begun == end});
  } while (begun != end);
}

void FillClock::add_line(std::uint32_t first_pixel, const slb::FillLine& line) {
  for (std::uint32_t i = 0; i < slb::kLinePixels; ++i)
    if ((line.pixels >> i & 1U) != 0)
      updates_.push_back({.index = first_pixel + i, .kind = SlbRequest::Kind::Chain});
}

void FillClock::add_plain(std::uint32_t first_pixel, const slb::FillLine& line) {
  if (flat_ && line.plain() && line.covered)
    updates_.push_back({.index = first_pixel, .kind = SlbRequest::Kind::PlainLine});
}

SlbMoves FillClock::cycle(SlbMemory& memory, Ports& ports) {
  memory.begin(ports);
  const bool room = lines_under_way_.size() < places_;
  const SlbMoves moves = update(memory);
  // The next line comes behind the last update of the one before.
  if (!at_work_ && !lines_under_way_.empty() && lines_under_way_.front() <= ports.now()) {
    lines_under_way_.pop_front();
    next_ = steps_[line_].first;
    end_ = steps_[line_].end;
    at_work_ = true;
    ++line_;
  }
  ask(ports.now(), room);
  memory.serve(ports);
  return moves;
}

/// A step: an update, or none.
SlbMoves FillClock::update(SlbMemory& memory) {
  SlbMoves moves;
  if (!at_work_) return moves;
  if (next_ != end_) {
    moves.waits = !memory.free();
    if (moves.waits) return moves;
    memory.take(updates_[next_++]);
  }
  moves.steps = true;
  at_work_ = next_ != end_;
  return moves;
}

/// A line and a span a cycle, each while there is a place for its answer.
void FillClock::ask(Cycle now, bool room) {
  const bool span_room = spans_under_way_.size() < places_;
  if (!spans_under_way_.empty() && spans_under_way_.front() <= now && room) {
    lines_under_way_.push_back(now + latency_ + 1);
    if (steps_[asked_++].ends_span) spans_under_way_.pop_front();
  }
  if (span_ == spans_ || !span_room) return;
  spans_under_way_.push_back(now + latency_ + 1);
  ++span_;
}

}  // namespace gnomon::golden::cycles
