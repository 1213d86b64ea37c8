// SPDX-License-Identifier: Apache-2.0
// The registry of parameters: every key of --set, with its type, range, default and meaning.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/base/result.hpp"

namespace gnomon::config {

inline constexpr std::string_view kEnvironmentPrefix = "GNOMON_SET_";

enum class Type : std::uint8_t { Integer, Number, Choice, Choices, Vector };

/// What a parameter can hold: Integer, Number, Choice (its word), Choices (its words, with commas) or Vector
/// (three numbers).
using Value = std::variant<std::int64_t, double, std::string, std::array<double, 3>>;

/// Choosing `word` gives the parameter `key` another default.
struct Implied {
  std::string_view word, key;
  Value preset;
};

/// What a parameter is about.
enum class Part : std::uint8_t {
  Run,
  System,  ///< the simulated system alone
  Memory,  ///< the way to memory, of the simulated system and of predicted cycles
};

struct Parameter {
  std::string_view key;
  Type type;
  double low, high;  ///< of Integer and Number, both ends included
  std::vector<std::string_view>
      words;              ///< of Choice, Choices, and of an Integer that takes certain values only
  Value preset;           ///< the default value
  std::string_view unit;  ///< empty where it has none
  std::string_view help;  ///< one line
  std::vector<Implied> implies = {};  ///< of Choice: what its words preset
  Part part = Part::Run;

  /// "16..2048", "on | off", "x,y,z": what may be written after key=.
  std::string range() const;
  /// The value that `text` writes, or why not: "res=9 is out of range 16..2048".
  Result<Value> parse(std::string_view text) const;
  /// "GNOMON_SET_RES": the environment variable that sets it.
  std::string environment() const;
};

/// All parameters of this build, in the order in which `gnomon params` shows them.
std::span<const Parameter> parameters();

/// The parameter named `key`, or one line that names the nearest key.
Result<const Parameter*> find_parameter(std::string_view key);

/// "a,b" -> a, b: the words of a value of Choices.
std::vector<std::string_view> split(std::string_view text);

/// As it would be written on the command line.
std::string to_text(const Value& value);

}  // namespace gnomon::config
