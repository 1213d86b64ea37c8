// SPDX-License-Identifier: Apache-2.0
// Spans are read, then their lines, then the steps that a line takes: three stages with queues between them.
#include "fill.hpp"

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

namespace gnomon::golden::cycles {
namespace {

constexpr std::size_t kSpanLines = 4;  // or a row, if it has fewer

/// A read port: at most `places` requests without their answers taken; answers in order.
class ReadPort {
 public:
  explicit ReadPort(Cycle latency)
      : latency_(latency), left_(std::bit_ceil(static_cast<std::size_t>(latency) + 3)) {}

  /// A request that is there from `earliest` on; returns when it is taken.
  Cycle ask(Cycle earliest) {
    asked_ = std::max(earliest, asks_ >= left_.size() ? left_[asks_ % left_.size()] + 1 : 0);
    return asked_;
  }
  /// Its answer is there from then on.
  Cycle answer() const { return std::max(asked_ + latency_ + 1, asks_ > 0 ? before_ + 1 : 0); }
  /// Its answer is taken.
  void leave(Cycle cycle) { left_[asks_++ % left_.size()] = before_ = cycle; }

 private:
  Cycle latency_, asked_ = 0, before_ = 0;
  std::vector<Cycle> left_;
  std::size_t asks_ = 0;
};

class Fill {
 public:
  Fill(const slb::SlbConfig& config, const HardwareTiming& timing, bool flat)
      : row_lines_(static_cast<std::size_t>(std::max(1, config.side() / slb::kLinePixels))),
        latency_(static_cast<Cycle>(timing.memory_latency)),
        flat_(flat),
        spans_(latency_),
        lines_(latency_) {}

  FillCycles sweep(std::span<const slb::FillLine> lines) {
    const std::size_t size = std::min(kSpanLines, row_lines_);
    for (; !lines.empty(); lines = lines.subspan(size)) span(lines.first(size));
    return {steps_, idle_};
  }

 private:
  void span(std::span<const slb::FillLine> lines) {
    next_span_ = spans_.ask(next_span_) + 1;
    Cycle asked = spans_.answer();
    const auto plain = [](const slb::FillLine& line) { return line.plain(); };
    auto line = std::find_if_not(lines.begin(), lines.end(), plain);
    auto behind = line == lines.end() ? line : std::find_if_not(line + 1, lines.end(), plain);
    asked = step(asked, lines.begin(), line, behind);
    for (line = behind; line != lines.end(); line = behind) {
      behind = std::find_if_not(line + 1, lines.end(), plain);
      asked = step(asked + 1, line, line, behind);
    }
    spans_.leave(asked);
  }

  using Line = std::span<const slb::FillLine>::iterator;

  /// A line with lines, the plain ones before it, and those behind it; or plain ones alone. Returns when it
  /// is asked for.
  Cycle step(Cycle earliest, Line first, Line line, Line end) {
    Cycle updates = line == end ? 0 : static_cast<Cycle>(line->groups());
    if (flat_)
      updates += static_cast<Cycle>(std::count_if(
          first, end, [](const slb::FillLine& other) { return other.plain() && other.covered; }));
    const Cycle cycles = std::max<Cycle>(1, updates);
    const Cycle asked = lines_.ask(std::max(earliest, next_line_));
    next_line_ = asked + 1;
    const Cycle begun = std::max(lines_.answer(), done_);
    lines_.leave(begun);
    done_ = begun + cycles;
    steps_ += cycles;
    constexpr Cycle kWritten = 2;
    idle_ = std::max({idle_, done_ + 1, updates == 0 ? 0 : done_ + latency_ + kWritten});
    return asked;
  }

  std::size_t row_lines_;
  Cycle latency_;
  bool flat_;
  ReadPort spans_, lines_;
  Cycle next_span_ = 1, next_line_ = 0, done_ = 0, steps_ = 0, idle_ = 1;
};

}  // namespace

FillCycles fill_cycles(const slb::FillSweep& sweep, bool flat, const slb::SlbConfig& config,
                       const HardwareTiming& timing) {
  return Fill(config, timing, flat).sweep(sweep.lines);
}

}  // namespace gnomon::golden::cycles
