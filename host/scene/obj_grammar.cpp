// SPDX-License-Identifier: Apache-2.0
// What a statement of an OBJ file must look like.
#include "host/scene/obj_grammar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace gnomon::scene {
namespace {

constexpr std::string_view kBlanks = " \t";

/// Cuts the next word off the front of `rest`; empty at the end.
std::string_view next_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
  const std::string_view word = rest.substr(0, std::min(rest.find_first_of(kBlanks), rest.size()));
  rest.remove_prefix(word.size());
  return word;
}

/// A word as an error message may show it: short, and printable whatever it holds.
std::string shown(std::string_view word) {
  constexpr std::size_t kLongest = 40;
  std::string text;
  for (const char c : word.substr(0, kLongest))
    text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return "'" + text + (word.size() > kLongest ? "...'" : "'");
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view without_sign(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  return word;
}

/// Length of the digits at the front of `text`.
std::size_t digits(std::string_view text) {
  return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_digit) - text.begin());
}

/// The value of [+-]digits[.digits][e[+-]digits], or nothing. Out of double's range: infinity or zero.
std::optional<double> number(std::string_view word) {
  const std::string_view unsigned_word = without_sign(word);
  if (unsigned_word.empty() || (!is_digit(unsigned_word[0]) && unsigned_word[0] != '.')) return std::nullopt;
  double value = 0;
  const auto [end, status] =
      std::from_chars(unsigned_word.data(), unsigned_word.data() + unsigned_word.size(), value);
  if (status == std::errc::invalid_argument || end != unsigned_word.data() + unsigned_word.size())
    return std::nullopt;
  // from_chars does not say on which side: strtod gives infinity or (next to) zero.
  if (status == std::errc::result_out_of_range)
    value = std::strtod(std::string(unsigned_word).c_str(), nullptr);
  return word.starts_with('-') ? -value : value;
}

bool names_a_non_finite_number(std::string_view word) {
  std::string lower;
  for (const char c : without_sign(word))
    lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower.starts_with("nan") || lower.starts_with("inf") || lower.starts_with("1.#");
}

/// x y z, then perhaps a weight, a colour, or both.
Result<ObjStatement> check_vertex(std::string_view rest) {
  std::size_t count = 0;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    const std::optional<double> value = number(word);
    if (names_a_non_finite_number(word) || (value && !std::isfinite(*value))) {
      return fail(fmt::format("coordinate {} is not finite, expected a finite number", shown(word)));
    }
    if (!value)
      return fail(
          fmt::format("malformed number {}, expected a coordinate such as -1.25 or 3e-2", shown(word)));
    if (++count <= 3 && std::abs(*value) > kLargestCoordinate) {
      return fail(fmt::format("coordinate {} is too large, expected at most {:g} in magnitude", shown(word),
                              kLargestCoordinate));
    }
  }
  if (count != 3 && count != 4 && count != 6 && count != 7) {
    return fail(fmt::format(
        "vertex has {} numbers, expected 3 coordinates (and perhaps a weight or a colour)", count));
  }
  return count == 4 || count == 7 ? ObjStatement::WeightedVertex : ObjStatement::Vertex;
}

/// [+-]digits
bool is_index(std::string_view word) {
  const std::string_view rest = without_sign(word);
  return !rest.empty() && digits(rest) == rest.size();
}

Result<void> check_corner(std::string_view word) {
  std::array<std::string_view, 3> part{};
  std::size_t parts = 0;
  for (std::string_view rest = word; parts < 3;) {
    const std::size_t slash = rest.find('/');
    part[parts++] = rest.substr(0, slash);
    if (slash == std::string_view::npos) break;
    rest.remove_prefix(slash + 1);
    if (parts == 3)
      return fail(fmt::format("malformed face corner {}, expected v, v/vt, v//vn or v/vt/vn", shown(word)));
  }
  const bool well_formed =
      is_index(part[0]) && (part[1].empty() || is_index(part[1])) && (part[2].empty() || is_index(part[2]));
  if (!well_formed) {
    return fail(fmt::format("malformed face corner {}, expected v, v/vt, v//vn or v/vt/vn", shown(word)));
  }
  std::int32_t value = 0;
  std::string_view index = part[0];
  if (index.starts_with('+')) index.remove_prefix(1);
  if (std::from_chars(index.data(), index.data() + index.size(), value).ec != std::errc{}) {
    return fail(fmt::format("vertex index {} is out of range, expected at most 2147483647", shown(part[0])));
  }
  return {};
}

Result<void> check_face(std::string_view rest) {
  std::size_t count = 0;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest), ++count) {
    if (Result<void> corner = check_corner(word); !corner) return corner;
  }
  if (count < 3)
    return fail(
        fmt::format("face has {} {}, expected at least 3", count, count == 1 ? "vertex" : "vertices"));
  return {};
}

/// Statements of the specification (and of common exporters) that say nothing about a control cage.
bool is_known_keyword(std::string_view word) {
  static constexpr std::array kKnown{
      "vt",     "vn",  "vp",     "vw",     "g",        "s",        "mg",         "usemtl",    "mtllib",
      "l",      "p",   "usemap", "maplib", "bevel",    "lod",      "curv",       "curv2",     "surf",
      "cstype", "deg", "bmat",   "step",   "parm",     "trim",     "hole",       "scrv",      "sp",
      "end",    "con", "ctech",  "stech",  "c_interp", "d_interp", "shadow_obj", "trace_obj", "bsp",
      "bzp",    "cdc", "cdp",    "res",    "call",     "csh",      "newline"};
  return std::find(kKnown.begin(), kKnown.end(), word) != kKnown.end();
}

bool is_binary(std::string_view line) {
  return std::any_of(line.begin(), line.end(),
                     [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; });
}

template <class T>
Result<T> tag_value(std::string_view& rest, std::string_view name, std::string_view kind) {
  const std::string_view word = next_word(rest);
  T value{};
  const auto [end, status] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty()) return fail(fmt::format("tag {} ends early, expected another {}", shown(name), kind));
  if (status != std::errc{} || end != word.data() + word.size()) {
    return fail(fmt::format("malformed {} {} in tag {}", kind, shown(word), shown(name)));
  }
  return value;
}

/// "2/1/0": how many integers, floats and strings follow.
Result<std::array<std::size_t, 3>> tag_counts(std::string_view word) {
  std::array<std::size_t, 3> counts{};
  const char* at = word.data();
  const char* const end = word.data() + word.size();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (i > 0 && (at == end || *at++ != '/')) return fail("");
    const auto [next, status] = std::from_chars(at, end, counts[i]);
    if (status != std::errc{}) return fail("");
    at = next;
  }
  if (at != end) return fail("");
  return counts;
}

}  // namespace

std::string_view without_comment(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    if (at == 0 || kBlanks.find(line[at - 1]) != std::string_view::npos) return line.substr(0, at);
  }
  return line;
}

Result<ObjStatement> check_statement(std::string_view line) {
  if (is_binary(line)) return fail("binary data, expected an OBJ text");
  std::string_view rest = line;
  const std::string_view keyword = next_word(rest);
  if (keyword.empty() || keyword.starts_with('#')) return ObjStatement::Blank;
  rest = without_comment(rest);
  if (keyword == "v") return check_vertex(rest);
  if (keyword == "f") return check_face(rest).map([] { return ObjStatement::Face; });
  if (keyword == "o") return ObjStatement::Object;
  if (keyword == "t") return ObjStatement::Tag;
  if (is_known_keyword(keyword)) return ObjStatement::Ignored;
  return fail(
      fmt::format("unknown statement {}, expected an OBJ statement such as v, f, o, g or t", shown(keyword)));
}

Result<ObjTag> parse_tag(std::string_view line) {
  std::string_view rest = without_comment(line);
  next_word(rest);
  ObjTag tag;
  tag.name = next_word(rest);
  const std::string_view counts_word = next_word(rest);
  const Result<std::array<std::size_t, 3>> counts = tag_counts(counts_word);
  if (tag.name.empty() || !counts) {
    return fail(fmt::format("malformed tag counts {}, expected 't name ints/floats/strings values...'",
                            shown(counts_word)));
  }
  // Counts are not trusted with memory: values are read until one is missing.
  for (std::size_t i = 0; i < (*counts)[0]; ++i) {
    const Result<std::int32_t> value = tag_value<std::int32_t>(rest, tag.name, "integer");
    if (!value) return tl::make_unexpected(value.error());
    tag.ints.push_back(*value);
  }
  for (std::size_t i = 0; i < (*counts)[1]; ++i) {
    const Result<double> value = tag_value<double>(rest, tag.name, "number");
    if (!value) return tl::make_unexpected(value.error());
    tag.floats.push_back(*value);
  }
  for (std::size_t i = 0; i < (*counts)[2]; ++i) {
    const std::string_view word = next_word(rest);
    if (word.empty()) return fail(fmt::format("tag {} ends early, expected another string", shown(tag.name)));
    tag.strings.emplace_back(word);
  }
  if (const std::string_view word = next_word(rest); !word.empty()) {
    return fail(fmt::format("tag {} goes on with {} after the {} values that it announced", shown(tag.name),
                            shown(word), tag.ints.size() + tag.floats.size() + tag.strings.size()));
  }
  return tag;
}

}  // namespace gnomon::scene
