// SPDX-License-Identifier: Apache-2.0
// A chart as SVG: two axes, points, lines, a legend. For papers: black on white, no script.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::sweep {

/// One direction of a chart.
class Scale {
 public:
  enum class Kind : std::uint8_t {
    Fitting,      ///< logarithmic where all values are positive and differ by more than 8 times, else linear
    Whole,        ///< linear, ticks at whole numbers
    Logarithmic,  ///< if all values are positive
  };
  explicit Scale(const std::vector<double>& values, Kind kind = Kind::Fitting);

  /// 0 at the low end, 1 at the high one.
  double at(double value) const;
  bool logarithmic() const { return logarithmic_; }
  /// Where labels stand, ascending.
  std::vector<double> ticks() const;

 private:
  Kind kind_;
  bool logarithmic_ = false;
  double low_ = 0, high_ = 1;
};

/// 1234567 -> "1.235 M", 0.0123 -> "0.0123": four digits.
std::string short_number(double value);

class Chart {
 public:
  Chart(Scale x, Scale y, std::string x_label, std::string y_label);

  /// Colour `series` of the palette, which repeats. Faint: small and pale; ringed: a circle around it.
  void point(double x, double y, std::size_t series, bool faint, bool ringed);
  using Points = std::vector<std::pair<double, double>>;
  void line(const Points& points, std::size_t series);
  /// In grey, dashed.
  void dashed(const Points& points);
  /// From point to point, first across, then down; black.
  void steps(const Points& points);
  void legend(std::size_t series, const std::string& text);
  void note(const std::string& text);

  /// The whole file.
  std::string svg(const std::string& title) const;

 private:
  std::pair<double, double> at(double x, double y) const;
  std::string path(const Points& points, bool steps) const;
  std::string axes() const;

  Scale x_, y_;
  std::string x_label_, y_label_;
  std::string marks_, legend_;
  std::size_t entries_ = 0;  ///< of the legend
};

}  // namespace gnomon::sweep
