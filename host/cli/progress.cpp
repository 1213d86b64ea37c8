// SPDX-License-Identifier: Apache-2.0
// How far a long job is, on a terminal.
#include "host/cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gnomon::cli {
namespace {

constexpr double kQuietSeconds = 1.0;
constexpr double kRefreshSeconds = 0.1;

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

std::string progress_text(std::string_view stage, double done, double seconds) {
  constexpr int kCells = 20;
  const double share = std::clamp(done, 0.0, 1.0);
  const int filled = static_cast<int>(share * kCells);
  std::string text =
      fmt::format("{:<12} [{:#<{}}{:.<{}}] {:3.0f} %", stage, "", filled, "", kCells - filled, 100 * share);
  // Before a hundredth is done an estimate says nothing.
  if (share < 0.01 || share >= 1) return text;
  const long left = std::lround(seconds * (1 - share) / share);
  return text + (left >= 60 ? fmt::format("  {} min {:02} s left", left / 60, left % 60)
                            : fmt::format("  {} s left", left));
}

void ProgressLine::update(std::string_view stage, double done) {
  if (!on_) return;
  const Clock::time_point now = Clock::now();
  if (stage != stage_) {
    stage_ = stage;
    start_ = last_ = now;
  }
  if (seconds_between(start_, now) < kQuietSeconds || seconds_between(last_, now) < kRefreshSeconds) return;
  last_ = now;
  shown_ = true;
  fmt::print(stderr, "\r\x1b[K{}", progress_text(stage, done, seconds_between(start_, now)));
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (shown_) fmt::print(stderr, "\r\x1b[K");
  shown_ = false;
}

}  // namespace gnomon::cli
