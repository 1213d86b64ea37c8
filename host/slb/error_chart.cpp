// SPDX-License-Identifier: Apache-2.0
// Displacement against memory as inline SVG.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/report/numbers.hpp"
#include "host/slb/report_page.hpp"

namespace gnomon::slb {
namespace {

constexpr double kWidth = 860, kHeight = 400, kLeft = 74, kRight = 44, kTop = 16, kBottom = 46;

/// A range of powers of ten.
struct Decades {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double value) {
    if (value <= 0) return;
    low = std::min(low, std::floor(std::log10(value)));
    high = std::max(high, std::ceil(std::log10(value)));
  }
  /// 0 at the low end, 1 at the high one.
  double at(double value) const { return (std::log10(value) - low) / std::max(high - low, 1.0); }
};

struct Chart {
  Decades memory, error;
  std::string svg;

  double x(double bits) const { return kLeft + memory.at(bits) * (kWidth - kLeft - kRight); }
  double y(double pixels) const { return kHeight - kBottom - error.at(pixels) * (kHeight - kTop - kBottom); }

  void grid() {
    for (int decade = static_cast<int>(memory.low); decade <= static_cast<int>(memory.high); ++decade) {
      const double value = std::pow(10, decade), at = x(value);
      svg += fmt::format(R"(<line class="grid" x1="{0:.1f}" y1="{1}" x2="{0:.1f}" y2="{2}"/>)", at, kTop,
                         kHeight - kBottom);
      svg += fmt::format(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{}</text>)", at,
                         kHeight - kBottom + 18, report::bits(static_cast<std::uint64_t>(value)));
    }
    for (int decade = static_cast<int>(error.low); decade <= static_cast<int>(error.high); ++decade) {
      const double value = std::pow(10, decade), at = y(value);
      svg += fmt::format(R"(<line class="grid" x1="{1}" y1="{0:.1f}" x2="{2}" y2="{0:.1f}"/>)", at, kLeft,
                         kWidth - kRight);
      svg +=
          fmt::format(R"(<text x="{}" y="{:.1f}" text-anchor="end">{:g}</text>)", kLeft - 8, at + 4, value);
    }
    svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="middle">memory</text>)", kWidth / 2, kHeight - 6);
    svg += fmt::format(
        R"svg(<text transform="translate(14 {}) rotate(-90)" text-anchor="middle">mean displacement, pixels</text>)svg",
        kHeight / 2);
  }

  /// `beside`: the label stands right of the point instead of above it.
  void point(const char* style, double bits, double pixels, const std::string& label, bool beside) {
    if (pixels <= 0) return;
    svg += fmt::format(
        R"(<circle class="{}" cx="{:.1f}" cy="{:.1f}" r="5"><title>{}: {:.3g} px, {}</title></circle>)",
        style, x(bits), y(pixels), label, pixels, report::bits(static_cast<std::uint64_t>(bits)));
    svg +=
        fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x(bits) + (beside ? 10 : 0),
                    y(pixels) + (beside ? 4 : -10), beside ? "start" : "middle", label);
  }
};

}  // namespace

std::string error_chart(const nlohmann::ordered_json& points) {
  Chart chart;
  const auto each = [&](auto&& visit) {
    for (const auto& point : points) {
      for (const char* method : {"buffer", "plain_map", "fine_map"}) {
        const auto& figures = point.at(method);
        visit(point, method, figures.at("memory_bits").template get<double>(),
              figures.at("displacement").template get<double>());
      }
    }
  };
  each([&](const auto&, const char*, double bits, double pixels) {
    if (pixels <= 0) return;
    chart.memory.take(bits);
    chart.error.take(pixels);
  });
  if (!(chart.memory.low <= chart.memory.high)) return "";
  chart.grid();
  bool plain = false;  // the same for every width
  each([&](const auto& point, const std::string& method, double bits, double pixels) {
    if (method == "plain_map" && std::exchange(plain, true)) return;
    const std::string width = fmt::format("F={}", point.at("frac_bits").template get<int>());
    if (method == "buffer") chart.point("buffer", bits, pixels, width, true);
    if (method == "plain_map") chart.point("map", bits, pixels, "plain map", false);
    if (method == "fine_map") chart.point("map", bits, pixels, width, false);
  });
  return fmt::format(
      R"(<svg class="chart" viewBox="0 0 {} {}" role="img" aria-label="Displacement against memory">{}</svg>)",
      kWidth, kHeight, chart.svg);
}

}  // namespace gnomon::slb
