// SPDX-License-Identifier: Apache-2.0
// Constraints by muParser, which knows numbers alone: a word becomes a number of its own.
#include "host/sweep/constraint.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/config/nearest.hpp"
#include "host/config/parameter.hpp"

namespace gnomon::sweep {

/// muParser holds their addresses.
struct Constraint::Variables {
  std::map<std::string, double> values;
};

namespace {

constexpr std::array<const char*, 3> kAxes{"_x", "_y", "_z"};

/// All words that any parameter takes; a word's number is its place.
std::vector<std::string> all_words() {
  std::vector<std::string> words;
  for (const config::Parameter& parameter : config::parameters()) {
    if (std::holds_alternative<std::string>(parameter.preset))
      words.insert(words.end(), parameter.words.begin(), parameter.words.end());
  }
  std::ranges::sort(words);
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

Result<double> number_of(const std::string& word) {
  static const std::vector<std::string> words = all_words();
  const auto at = std::ranges::find(words, word);
  if (at != words.end()) return static_cast<double>(at - words.begin());
  const std::vector<std::string_view> known(words.begin(), words.end());
  return fail(fmt::format("unknown word '{}', {}", word, config::suggestion(word, known)));
}

/// 'word' and "word" become their numbers.
Result<std::string> without_words(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\'' && text[i] != '"') {
      plain += text[i];
      continue;
    }
    const std::size_t end = text.find(text[i], i + 1);
    if (end == std::string::npos) return fail("a quote is not closed");
    const Result<double> number = number_of(text.substr(i + 1, end - i - 1));
    if (!number) return tl::make_unexpected(number.error());
    plain += fmt::format("{}", *number);
    i = end;
  }
  return plain;
}

std::vector<std::string> names_of(const config::Parameter& parameter) {
  const std::string key(parameter.key);
  if (parameter.type != config::Type::Vector) return {key};
  std::vector<std::string> names;
  names.reserve(std::size(kAxes));
  for (const char* axis : kAxes) names.push_back(key + axis);
  return names;
}

}  // namespace

Constraint::Constraint()
    : variables_(std::make_unique<Variables>()), parser_(std::make_unique<mu::Parser>()) {}
Constraint::Constraint(Constraint&&) noexcept = default;
Constraint& Constraint::operator=(Constraint&&) noexcept = default;
Constraint::~Constraint() = default;

Result<Constraint> Constraint::parse(const std::string& text) {
  const Result<std::string> plain = without_words(text);
  if (!plain) return fail(fmt::format("in \"{}\": {}", text, plain.error().message));
  Constraint made;
  for (const config::Parameter& parameter : config::parameters()) {
    for (const std::string& name : names_of(parameter)) {
      double& value = made.variables_->values[name];
      made.parser_->DefineVar(name, &value);
    }
  }
  try {
    made.parser_->SetExpr(*plain);
    made.parser_->Eval();
  } catch (const mu::Parser::exception_type& problem) {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : made.variables_->values) names.push_back(name);
    const bool unknown = problem.GetCode() == mu::ecUNASSIGNABLE_TOKEN;
    return fail(fmt::format("in \"{}\": {}", text,
                            unknown ? fmt::format("unknown key '{}', {}", problem.GetToken(),
                                                  config::suggestion(problem.GetToken(), names))
                                    : problem.GetMsg()));
  }
  return made;
}

void Constraint::assign(const config::Settings& settings) {
  for (const config::Parameter& parameter : config::parameters()) {
    const config::Value& value = settings.entry(parameter.key).value;
    const std::string key(parameter.key);
    if (const auto* vector = std::get_if<std::array<double, 3>>(&value)) {
      for (std::size_t i = 0; i < vector->size(); ++i) variables_->values.at(key + kAxes[i]) = (*vector)[i];
    } else if (const auto* word = std::get_if<std::string>(&value)) {
      variables_->values.at(key) = number_of(*word).value_or(-1);  // several words are none
    } else if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      variables_->values.at(key) = static_cast<double>(*integer);
    } else {
      variables_->values.at(key) = std::get<double>(value);
    }
  }
}

bool Constraint::holds(const config::Settings& settings) {
  assign(settings);
  const double value = parser_->Eval();
  return !std::isnan(value) && value != 0;
}

}  // namespace gnomon::sweep
