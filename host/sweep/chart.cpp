// SPDX-License-Identifier: Apache-2.0
// A chart as SVG.
#include "host/sweep/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gnomon::sweep {
namespace {

constexpr double kWidth = 860, kHeight = 520, kLeft = 92, kRight = 160, kTop = 40, kBottom = 56;
constexpr double kLogarithmic = 8;  // times between the ends
constexpr double kLine = 18;        // between lines of the legend
constexpr std::array<const char*, 8> kPalette{"#2f6db3", "#c4472e", "#2b9a8b", "#e0a22c",
                                              "#8d5fb8", "#5a7d2a", "#b0447f", "#5c646f"};
constexpr const char* kStyle =
    "text{font:13px sans-serif;fill:#222}.title{font-size:16px;font-weight:bold}.grid{stroke:#ddd}"
    ".frame{fill:none;stroke:#888}";

const char* colour(std::size_t series) {
  return kPalette.at(series % kPalette.size());
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return safe;
}

/// 1, 2 or 5 times a power of ten, at most `most` of them in `span`.
double step_for(double span, double most) {
  const double decade = std::pow(10, std::floor(std::log10(span / most)));
  for (const double times : {1.0, 2.0, 5.0}) {
    if (span / (times * decade) <= most) return times * decade;
  }
  return 10 * decade;
}

}  // namespace

Scale::Scale(const std::vector<double>& values, Kind kind) : kind_(kind) {
  if (values.empty()) return;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double least = kind == Kind::Logarithmic ? 0 : kLogarithmic;
  logarithmic_ = kind != Kind::Whole && *low > 0 && *high / *low > least;
  const double span = *high > *low ? *high - *low : std::max(std::abs(*high), 1.0);
  low_ = logarithmic_ ? std::log10(*low / 1.25) : *low - 0.05 * span;
  high_ = logarithmic_ ? std::log10(*high * 1.25) : *high + 0.05 * span;
}

double Scale::at(double value) const {
  return ((logarithmic_ ? std::log10(value) : value) - low_) / (high_ - low_);
}

std::vector<double> Scale::ticks() const {
  std::vector<double> ticks;
  if (!logarithmic_) {
    const double step =
        kind_ == Kind::Whole ? std::max(1.0, step_for(high_ - low_, 10)) : step_for(high_ - low_, 8);
    const auto last = static_cast<std::int64_t>(std::floor(high_ / step));
    for (auto i = static_cast<std::int64_t>(std::ceil(low_ / step)); i <= last; ++i)
      ticks.push_back(static_cast<double>(i) * step);
    return ticks;
  }
  // Few decades: 2 and 5 besides.
  const bool fine = high_ - low_ < 3;
  const int last = static_cast<int>(std::floor(high_));
  for (int decade = static_cast<int>(std::floor(low_)); decade <= last; ++decade) {
    for (const double times : {1.0, 2.0, 5.0}) {
      const double value = std::log10(times) + decade;
      if ((fine || times == 1) && value >= low_ && value <= high_) ticks.push_back(std::pow(10, value));
    }
  }
  return ticks;
}

std::string short_number(double value) {
  constexpr std::array<std::pair<double, const char*>, 3> kUnits{{{1e9, " G"}, {1e6, " M"}, {1e3, " k"}}};
  for (const auto& [unit, name] : kUnits) {
    if (std::abs(value) >= unit) return fmt::format("{:.4g}{}", value / unit, name);
  }
  return fmt::format("{:.4g}", value);
}

Chart::Chart(Scale x, Scale y, std::string x_label, std::string y_label)
    : x_(x), y_(y), x_label_(std::move(x_label)), y_label_(std::move(y_label)) {}

std::pair<double, double> Chart::at(double x, double y) const {
  return {kLeft + x_.at(x) * (kWidth - kLeft - kRight),
          kHeight - kBottom - y_.at(y) * (kHeight - kTop - kBottom)};
}

void Chart::point(double x, double y, std::size_t series, bool faint, bool ringed) {
  const auto [px, py] = at(x, y);
  marks_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\"{}/>\n", px, py,
                        faint ? 3 : 5, colour(series), faint ? " opacity=\"0.35\"" : "");
  if (ringed)
    marks_ += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"9\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", px,
        py, colour(series));
}

std::string Chart::path(const Points& points, bool steps) const {
  std::string path;
  for (const auto& [x, y] : points) {
    const auto [px, py] = at(x, y);
    if (steps && !path.empty()) path += fmt::format("H{:.1f}", px);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
  }
  return path;
}

void Chart::line(const Points& points, std::size_t series) {
  marks_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n",
                        path(points, false), colour(series));
  for (const auto& [x, y] : points) point(x, y, series, false, false);
}

void Chart::dashed(const Points& points) {
  marks_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#888\" stroke-dasharray=\"6 5\"/>\n",
                        path(points, false));
}

void Chart::steps(const Points& points) {
  marks_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#222\" stroke-width=\"1.5\"/>\n",
                        path(points, true));
}

void Chart::legend(std::size_t series, const std::string& text) {
  const double y = kTop + 10 + kLine * static_cast<double>(entries_++);
  legend_ += fmt::format(
      "<circle cx=\"{}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"/><text x=\"{}\" y=\"{:.1f}\">{}</text>\n",
      kWidth - kRight + 18, y, colour(series), kWidth - kRight + 30, y + 4, escaped(text));
}

void Chart::note(const std::string& text) {
  const double y = kTop + 14 + kLine * static_cast<double>(entries_++);
  legend_ += fmt::format("<text x=\"{}\" y=\"{:.1f}\">{}</text>\n", kWidth - kRight + 12, y, escaped(text));
}

std::string Chart::axes() const {
  std::string text;
  const double bottom = kHeight - kBottom, right = kWidth - kRight;
  const auto place = [&](const Scale& scale, double tick) { return scale.at(tick); };
  for (const double tick : x_.ticks()) {
    const double x = kLeft + place(x_, tick) * (right - kLeft);
    text += fmt::format(
        "<path class=\"grid\" d=\"M{0:.1f} {1}V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4}</text>\n",
        x, kTop, bottom, bottom + 18, short_number(tick));
  }
  for (const double tick : y_.ticks()) {
    const double y = bottom - place(y_, tick) * (bottom - kTop);
    text += fmt::format(
        "<path class=\"grid\" d=\"M{1} {0:.1f}H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5}</text>\n",
        y, kLeft, right, kLeft - 8, y + 4, short_number(tick));
  }
  text += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", kLeft, kTop,
                      right - kLeft, bottom - kTop);
  text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", (kLeft + right) / 2,
                      kHeight - 14, escaped(x_label_));
  text += fmt::format("<text transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                      (kTop + bottom) / 2, escaped(y_label_));
  return text;
}

std::string Chart::svg(const std::string& title) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<style>{2}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
      "<text class=\"title\" x=\"{3}\" y=\"26\">{4}</text>\n{5}{6}{7}</svg>\n",
      kWidth, kHeight, kStyle, kLeft, escaped(title), axes(), marks_, legend_);
}

}  // namespace gnomon::sweep
