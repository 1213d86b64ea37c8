// SPDX-License-Identifier: Apache-2.0
// How far a long job is, on a terminal.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace gnomon::cli {

/// One line on stderr that is rewritten in place: stage, bar, percent, time left. Shows nothing for jobs of
/// less than a second, and nothing at all when it is off. Not for several threads at once.
class ProgressLine {
 public:
  explicit ProgressLine(bool on) : on_(on) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `done` runs from 0 to 1 within a stage; a new stage name starts a new clock.
  void update(std::string_view stage, double done);
  /// Wipes the line, so that other output can follow.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool on_;
  bool shown_ = false;
  std::string stage_;
  Clock::time_point start_, last_;
};

/// "bar" of 20 cells, percent and the time left after `seconds` of work: what ProgressLine shows.
std::string progress_text(std::string_view stage, double done, double seconds);

}  // namespace gnomon::cli
