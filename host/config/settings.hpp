// SPDX-License-Identifier: Apache-2.0
// Which value every parameter has, and who said so: flag > environment > scene file > default.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "host/config/parameter.hpp"

namespace gnomon::config {

/// "key=value" as somebody wrote it, not yet looked at.
struct Assignment {
  std::string key, text;
  std::string origin;  ///< for messages: "command line", "environment GNOMON_SET_RES", "scene.toml:7"
};

/// Splits "key=value" of a --set flag.
Result<Assignment> parse_set_flag(std::string_view flag);

/// The assignments among `environment`'s "NAME=value" entries: GNOMON_SET_RES=128 sets res.
std::vector<Assignment> environment_assignments(std::span<const std::string> environment);

class Settings {
 public:
  struct Entry {
    Value value;
    std::string origin;  ///< "default", an Assignment's, or "key=word" of the choice that implies it
  };

  /// Later sources win over earlier ones, and within a source the later assignment; what no source sets takes
  /// the default that a choice implies, else its own. Errors are one line, "origin: error: res=9 is out of
  /// range 16..2048".
  static Result<Settings> resolve(std::span<const std::vector<Assignment>> weakest_first);

  const Entry& entry(std::string_view key) const { return entries_.at(std::string(key)); }
  std::int64_t integer(std::string_view key) const { return std::get<std::int64_t>(entry(key).value); }
  double number(std::string_view key) const { return std::get<double>(entry(key).value); }
  const std::string& word(std::string_view key) const { return std::get<std::string>(entry(key).value); }
  /// Of a parameter that takes a list: its words.
  std::vector<std::string> words(std::string_view key) const;
  bool is_on(std::string_view key) const { return word(key) == "on"; }
  std::array<double, 3> vector(std::string_view key) const {
    return std::get<std::array<double, 3>>(entry(key).value);
  }
  /// The words "--set key=value ..." for everything that is not at its default, implied ones included.
  std::vector<std::string> as_flags() const;

 private:
  Entry default_of(const Parameter& parameter) const;

  std::map<std::string, Entry> entries_;
};

}  // namespace gnomon::config
