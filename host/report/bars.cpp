// SPDX-License-Identifier: Apache-2.0
// Horizontal bars as inline SVG.
#include "host/report/bars.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>

namespace gnomon::report {
namespace {

constexpr double kWidth = 1000;  // of the drawing; the page stretches it

std::string escape(const std::string& text) {
  return kainjow::mustache::html_escape(text);
}

std::string rectangle(const Segment& segment, double start, double full) {
  // What is there at all is seen: at least one thousandth of the width.
  const double width = std::max(segment.value / full * kWidth, 1.0);
  const double x = std::min(start / full * kWidth, kWidth - width);
  return fmt::format(
      R"(<rect class="{}" x="{:.2f}" y="0" width="{:.2f}" height="10"><title>{}</title></rect>)",
      segment.style, x, width, escape(segment.label));
}

std::string drawing(const std::string& label, const std::string& content) {
  return fmt::format(
      R"(<svg class="bar" viewBox="0 0 {:.0f} 10" preserveAspectRatio="none" role="img" aria-label="{}">{}</svg>)",
      kWidth, escape(label), content);
}

}  // namespace

std::string stacked_bar(std::span<const Segment> segments, double full, const std::string& label) {
  std::string content;
  double start = 0;
  for (const Segment& segment : segments) {
    if (segment.value > 0) content += rectangle(segment, start, full);
    start += segment.value;
  }
  return drawing(label, content);
}

std::string waterfall_bar(const Segment& segment, double start, double full, const std::string& label) {
  return drawing(label, full > 0 ? rectangle(segment, start, full) : "");
}

}  // namespace gnomon::report
