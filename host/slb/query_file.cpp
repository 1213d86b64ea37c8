// SPDX-License-Identifier: Apache-2.0
// Queries from a CSV file, answers to one.
#include "host/slb/query_file.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "host/scene/text_lines.hpp"

namespace gnomon::slb {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::vector<std::string_view> columns_of(std::string_view line) {
  std::vector<std::string_view> columns;
  for (std::size_t begin = 0;;) {
    const std::size_t comma = line.find(',', begin);
    columns.push_back(trimmed(line.substr(begin, comma - begin)));
    if (comma == std::string_view::npos) return columns;
    begin = comma + 1;
  }
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_header(const std::vector<std::string_view>& columns) {
  static constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  return std::equal(columns.begin(), columns.end(), kNames.begin(), kNames.end());
}

}  // namespace

Result<QueryFile> read_queries(const std::filesystem::path& path) {
  Result<scene::TextLines> lines = scene::TextLines::open(path);
  if (!lines) return tl::make_unexpected(lines.error());
  QueryFile file;
  std::size_t blank = 0;  // the first blank line; only more of them may follow
  const auto refuse = [&](std::size_t line, const std::string& message) {
    return fail(fmt::format("{}:{}: error: {}", path.string(), line, message));
  };
  while (lines->next()) {
    if (trimmed(lines->text()).empty()) {
      if (blank == 0) blank = lines->number();
      continue;
    }
    if (blank != 0) return refuse(blank, "a blank line between rows, expected x,y,z");
    const std::vector<std::string_view> columns = columns_of(lines->text());
    if (lines->number() == 1 && is_header(columns)) {
      file.has_header = true;
      continue;
    }
    if (columns.size() != 3) {
      return refuse(lines->number(), fmt::format("{} {}, expected three: x,y,z", columns.size(),
                                                 columns.size() == 1 ? "column" : "columns"));
    }
    std::array<double, 3> row{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::optional<double> value = finite_number(columns[i]);
      if (!value) {
        return refuse(lines->number(),
                      fmt::format("{} is '{}', expected a finite number", "xyz"[i], columns[i]));
      }
      row[i] = *value;
    }
    file.receivers.push_back({row[0], row[1], row[2]});
  }
  if (!lines->read_error().empty()) return fail(path.string() + ": error: " + lines->read_error());
  if (file.receivers.empty()) return fail(path.string() + ": error: holds no queries, expected rows x,y,z");
  return file;
}

std::string answers_text(const std::vector<bool>& shadows) {
  std::string text;
  text.reserve(2 * shadows.size());
  for (const bool shadow : shadows) text += shadow ? "1\n" : "0\n";
  return text;
}

}  // namespace gnomon::slb
