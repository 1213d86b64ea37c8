// SPDX-License-Identifier: Apache-2.0
// JSON with the place inside its tree where reading it fails.
#include "host/slb/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

namespace gnomon::slb {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestPath = 100;  // of one that somebody may want to read

Result<std::string> text_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return fail(path.string() + ": error: is a directory, expected a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  // An empty file sets the stream's failbit, too.
  if (file && file.peek() != std::ifstream::traits_type::eof()) text << file.rdbuf();
  if (!file && !file.eof())
    return fail(fmt::format("{}: error: cannot be read: {}", path.string(), std::strerror(errno)));
  return text.str();
}

/// Follows the parser through the tree.
class Tracker {
 public:
  bool event(json::parse_event_t event, const json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
        levels_.push_back({false, 0, "", {}});
        break;
      case json::parse_event_t::array_start:
        levels_.push_back({true, 0, "", {}});
        break;
      case json::parse_event_t::key:
        levels_.back().key = parsed.get<std::string>();
        if (!levels_.back().seen.insert(levels_.back().key).second && !repeated_) repeated_ = path();
        break;
      case json::parse_event_t::object_end:
      case json::parse_event_t::array_end:
        levels_.pop_back();
        finish_value();
        break;
      case json::parse_event_t::value:
        finish_value();
        break;
    }
    return true;
  }

  /// Of the value being read.
  JsonPath path() const {
    JsonPath path;
    for (const Level& level : levels_) {
      if (level.array)
        path.emplace_back(level.index);
      else if (!level.key.empty())
        path.emplace_back(level.key);
    }
    return path;
  }
  /// The first key that an object has twice.
  const std::optional<JsonPath>& repeated() const { return repeated_; }

 private:
  struct Level {
    bool array;
    std::size_t index;
    std::string key;
    std::set<std::string> seen;
  };
  void finish_value() {
    if (!levels_.empty() && levels_.back().array) ++levels_.back().index;
  }
  std::vector<Level> levels_;
  std::optional<JsonPath> repeated_;
};

/// The word around a byte of the text: what the parser stumbled over.
std::string word_at(const std::string& text, std::size_t at) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
  };
  if (at >= text.size() || !in_word(text[at])) return "";
  std::size_t begin = at, end = at;
  while (begin > 0 && in_word(text[begin - 1])) --begin;
  while (end < text.size() && in_word(text[end])) ++end;
  return text.substr(begin, end - begin);
}

bool means_no_number(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  word.erase(0, word.find_first_not_of("+-") == std::string::npos ? 0 : word.find_first_not_of("+-"));
  return word == "nan" || word == "inf" || word == "infinity";
}

/// A parser's message without its error number and place, as one line.
std::string reason(const char* what) {
  std::string text = what;
  for (const char* cut : {"] ", "column "}) {
    if (const std::size_t at = text.find(cut); at != std::string::npos) text.erase(0, at + std::strlen(cut));
  }
  if (const std::size_t at = text.find(": "); at != std::string::npos && std::isdigit(text.front()) != 0)
    text.erase(0, at + 2);
  for (char& c : text) c = static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return text;
}

}  // namespace

std::string to_text(const JsonPath& path) {
  std::string text;
  for (const JsonStep& step : path) {
    if (text.size() > kLongestPath) return text + "...";
    if (const auto* index = std::get_if<std::size_t>(&step))
      text += fmt::format("[{}]", *index);
    else
      text += (text.empty() ? "" : ".") + std::get<std::string>(step);
  }
  return text;
}

Result<json> read_json(const std::filesystem::path& path, std::string (*describe)(const JsonPath&)) {
  const Result<std::string> text = text_of(path);
  if (!text) return tl::make_unexpected(text.error());
  Tracker tracker;
  const auto where = [&](const JsonPath& at) {
    const std::string place = describe(at);
    return place.empty() ? "" : place + ": ";
  };
  try {
    json tree = json::parse(*text, [&](int, json::parse_event_t event, const json& parsed) {
      return tracker.event(event, parsed);
    });
    if (!tracker.repeated()) return tree;
    return fail(fmt::format("{}: error: {}key appears twice", path.string(), where(*tracker.repeated())));
  } catch (const json::parse_error& error) {
    const std::size_t at = std::min(error.byte == 0 ? 0 : error.byte - 1, text->size());
    const auto line = 1 + std::count(text->begin(), text->begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::string word = word_at(*text, at);
    const std::string why = means_no_number(word) ? fmt::format("{} is not a finite number", word)
                                                  : "is not JSON: " + reason(error.what());
    return fail(fmt::format("{}:{}: error: {}{}", path.string(), line, where(tracker.path()), why));
  } catch (const json::out_of_range& error) {
    return fail(fmt::format("{}: error: {}{}", path.string(), where(tracker.path()),
                            reason(error.what()) + ", expected a finite number"));
  }
}

}  // namespace gnomon::slb
