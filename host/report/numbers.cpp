// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them.
#include "host/report/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace gnomon::report {
namespace {

/// Three significant digits of a value between 1 and 1000.
std::string three_digits(double value) {
  return fmt::format("{:.{}f}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-_./=:,+@%").find(c) != std::string_view::npos;
}

}  // namespace

std::string with_commas(std::uint64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text.push_back(',');
    text.push_back(digits[i]);
  }
  return text;
}

std::string percent(double share) {
  return std::isfinite(share) ? fmt::format("{:.3f} %", 100 * share) : "–";
}

std::string duration(double seconds) {
  static constexpr std::array<std::pair<double, const char*>, 3> kUnits{
      {{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}}};
  if (seconds >= 999.5) return fmt::format("{:.0f} s", seconds);
  for (const auto& [unit, name] : kUnits) {
    if (seconds >= 0.9995 * unit) return three_digits(seconds / unit) + " " + name;
  }
  return fmt::format("{:.0f} ns", seconds * 1e9);
}

std::string bits(std::uint64_t count) {
  static constexpr std::array<std::pair<double, const char*>, 3> kUnits{
      {{1e9, "Gbit"}, {1e6, "Mbit"}, {1e3, "kbit"}}};
  const double value = static_cast<double>(count);
  for (const auto& [unit, name] : kUnits) {
    if (value >= 0.9995 * unit) return three_digits(value / unit) + " " + name;
  }
  return fmt::format("{} bit", count);
}

std::string fixed(double value, int digits) {
  return fmt::format("{:.{}f}", value, digits);
}

std::string shell_line(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    if (!word.empty() && std::ranges::all_of(word, is_plain)) {
      line += word;
      continue;
    }
    line.push_back('\'');
    for (const char c : word) {
      if (c == '\'') line.append("'\\'");  // ends the quotes, a quote by itself, and on
      line.push_back(c);
    }
    line.push_back('\'');
  }
  return line;
}

}  // namespace gnomon::report
