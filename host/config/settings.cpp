// SPDX-License-Identifier: Apache-2.0
// Which value every parameter has, and who said so.
#include "host/config/settings.hpp"

#include <fmt/format.h>

#include <functional>
#include <set>

namespace gnomon::config {

Result<Assignment> parse_set_flag(std::string_view flag) {
  const std::size_t equals = flag.find('=');
  if (equals == std::string_view::npos || equals == 0) {
    return fail(fmt::format("command line: error: --set {} has no value, expected --set key=value", flag));
  }
  return Assignment{std::string(flag.substr(0, equals)), std::string(flag.substr(equals + 1)),
                    "command line"};
}

std::vector<Assignment> environment_assignments(std::span<const std::string> environment) {
  std::vector<Assignment> found;
  for (const std::string& entry : environment) {
    const std::size_t equals = entry.find('=');
    if (!entry.starts_with(kEnvironmentPrefix) || equals == std::string::npos) continue;
    std::string key = entry.substr(kEnvironmentPrefix.size(), equals - kEnvironmentPrefix.size());
    for (char& c : key) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    found.push_back({std::move(key), entry.substr(equals + 1), "environment " + entry.substr(0, equals)});
  }
  return found;
}

Settings::Entry Settings::default_of(const Parameter& parameter) const {
  for (const Parameter& choice : parameters()) {
    for (const Implied& implied : choice.implies) {
      if (implied.key != parameter.key || word(choice.key) != implied.word) continue;
      return {implied.preset, fmt::format("{}={}", choice.key, implied.word)};
    }
  }
  return {parameter.preset, "default"};
}

Result<Settings> Settings::resolve(std::span<const std::vector<Assignment>> weakest_first) {
  Settings settings;
  for (const Parameter& parameter : parameters()) {
    settings.entries_[std::string(parameter.key)] = {parameter.preset, "default"};
  }
  // Not by their origin: a subcommand's own default is called "default" too.
  std::set<std::string, std::less<>> assigned;
  for (const std::vector<Assignment>& source : weakest_first) {
    for (const Assignment& assignment : source) {
      const Result<const Parameter*> parameter = find_parameter(assignment.key);
      if (!parameter) return fail(assignment.origin + ": error: " + parameter.error().message);
      Result<Value> value = (*parameter)->parse(assignment.text);
      if (!value) return fail(assignment.origin + ": error: " + value.error().message);
      settings.entries_[assignment.key] = {std::move(*value), assignment.origin};
      assigned.insert(assignment.key);
    }
  }
  for (const Parameter& parameter : parameters()) {
    if (assigned.contains(parameter.key)) continue;
    settings.entries_.at(std::string(parameter.key)) = settings.default_of(parameter);
  }
  return settings;
}

std::vector<std::string> Settings::words(std::string_view key) const {
  const std::vector<std::string_view> parts = split(word(key));
  return {parts.begin(), parts.end()};
}

std::vector<std::string> Settings::as_flags() const {
  std::vector<std::string> flags;
  for (const Parameter& parameter : parameters()) {
    const Entry& e = entry(parameter.key);
    if (e.value == default_of(parameter).value) continue;
    flags.emplace_back("--set");
    flags.push_back(fmt::format("{}={}", parameter.key, to_text(e.value)));
  }
  return flags;
}

}  // namespace gnomon::config
