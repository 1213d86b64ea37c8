// SPDX-License-Identifier: Apache-2.0
// Axes of a specification.
#include "host/sweep/axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "host/config/parameter.hpp"

namespace gnomon::sweep {
namespace {

using config::Document;
using Pointer = Document::Pointer;

/// More is a slip of the pen: a sweep of a million points on one axis alone.
constexpr std::size_t kMostValues = 1000000;

/// The shortest text that gives the number back.
std::string text_of(double value) {
  return fmt::format("{}", value);
}

Result<std::string> text_at(const Document& document, const Pointer& at) {
  const nlohmann::json& value = document.root().at(at);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  if (value.is_number()) return text_of(value.get<double>());
  const bool three =
      value.is_array() && value.size() == 3 && std::ranges::all_of(value, &nlohmann::json::is_number);
  if (!three) return document.refuse(at, "expected a number, a word or three numbers");
  return fmt::format("{},{},{}", value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

struct Range {
  double from = 0, to = 0, step = 0;  ///< step 0: not given
  std::size_t count = 0;              ///< 0: not given
  bool logarithmic = false;
};

Result<double> number_at(const Document& document, const Pointer& at) {
  const nlohmann::json& value = document.root().at(at);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    return document.refuse(at, "expected a number");
  return value.get<double>();
}

Result<Range> read_range(const Document& document, const Pointer& at) {
  if (auto known = document.check_keys(at, {"from", "to", "step", "count", "scale"}); !known)
    return tl::make_unexpected(known.error());
  const nlohmann::json& table = document.root().at(at);
  Range range;
  for (const auto& [key, member] : {std::pair{"from", &Range::from}, {"to", &Range::to}}) {
    if (!table.contains(key)) return document.refuse(at, fmt::format("has no '{}'", key));
    const Result<double> value = number_at(document, at / key);
    if (!value) return tl::make_unexpected(value.error());
    range.*member = *value;
  }
  if (range.to < range.from) return document.refuse(at / "to", "is smaller than 'from'");
  if (table.contains("step") && table.contains("count"))
    return document.refuse(at / "step", "next to 'count', expected one or the other");
  if (table.contains("step")) {
    const Result<double> step = number_at(document, at / "step");
    if (!step) return tl::make_unexpected(step.error());
    if (!(*step > 0)) return document.refuse(at / "step", "expected more than 0");
    range.step = *step;
  }
  if (table.contains("count")) {
    const nlohmann::json& count = table.at("count");
    if (!count.is_number_integer() || count.get<std::int64_t>() < 2 ||
        count.get<std::int64_t>() > static_cast<std::int64_t>(kMostValues))
      return document.refuse(at / "count", fmt::format("expected a whole number, 2..{}", kMostValues));
    range.count = count.get<std::size_t>();
  }
  if (table.contains("scale")) {
    const nlohmann::json& scale = table.at("scale");
    if (scale != "linear" && scale != "log")
      return document.refuse(at / "scale", "expected \"linear\" or \"log\"");
    if (range.count == 0) return document.refuse(at / "scale", "needs a 'count'");
    range.logarithmic = scale == "log";
    if (range.logarithmic && !(range.from > 0))
      return document.refuse(at / "from", "expected more than 0 on a logarithmic scale");
  }
  return range;
}

/// `count` numbers, both ends exact.
std::vector<double> spread(const Range& range) {
  std::vector<double> values;
  for (std::size_t i = 0; i < range.count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(range.count - 1);
    values.push_back(range.logarithmic ? range.from * std::pow(range.to / range.from, t)
                                       : range.from + (range.to - range.from) * t);
  }
  values.back() = range.to;
  return values;
}

/// Values of `from`, `from + step`, ... that do not pass `to` by more than rounding.
std::vector<double> steps(const Range& range) {
  const double step = range.step > 0 ? range.step : 1;
  const double count = std::floor((range.to - range.from) / step + 1e-9);
  std::vector<double> values;
  for (double i = 0; i <= count && values.size() <= kMostValues; ++i) values.push_back(range.from + i * step);
  return values;
}

Result<std::vector<std::string>> range_values(const Document& document, const Pointer& at,
                                              const config::Parameter& parameter) {
  if (parameter.type != config::Type::Integer && parameter.type != config::Type::Number)
    return document.refuse(at, fmt::format("{} takes words, expected a list", parameter.key));
  const Result<Range> range = read_range(document, at);
  if (!range) return tl::make_unexpected(range.error());
  const bool whole = parameter.type == config::Type::Integer;
  if (!whole && range->count == 0 && range->step == 0)
    return document.refuse(at, "has neither 'count' nor 'step'");
  std::vector<std::string> texts;
  for (const double value : range->count > 0 ? spread(*range) : steps(*range))
    texts.push_back(whole && range->count > 0 ? text_of(std::round(value)) : text_of(value));
  return texts;
}

Result<std::vector<std::string>> listed_values(const Document& document, const Pointer& at) {
  const nlohmann::json& list = document.root().at(at);
  if (!list.is_array() || list.empty())
    return document.refuse(at, "expected a list of values or a table with 'from' and 'to'");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Result<std::string> text = text_at(document, at / i);
    if (!text) return tl::make_unexpected(text.error());
    texts.push_back(std::move(*text));
  }
  return texts;
}

}  // namespace

Result<std::string> read_value(const Document& document, const Pointer& at, const std::string& key) {
  const auto parameter = config::find_parameter(key);
  if (!parameter) return document.refuse(at, parameter.error().message);
  const Result<std::string> text = text_at(document, at);
  if (!text) return tl::make_unexpected(text.error());
  const Result<config::Value> value = (*parameter)->parse(*text);
  if (!value) return document.refuse(at, value.error().message);
  return config::to_text(*value);
}

Result<Axis> read_axis(const Document& document, const Pointer& at, const std::string& key) {
  const auto parameter = config::find_parameter(key);
  if (!parameter) return document.refuse(at, parameter.error().message);
  const auto texts = document.root().at(at).is_object() ? range_values(document, at, **parameter)
                                                        : listed_values(document, at);
  if (!texts) return tl::make_unexpected(texts.error());
  if (texts->size() > kMostValues)
    return document.refuse(at, fmt::format("more than {} values", kMostValues));
  Axis axis{key, {}};
  for (const std::string& text : *texts) {
    const Result<config::Value> value = (*parameter)->parse(text);
    if (!value) return document.refuse(at, value.error().message);
    std::string written = config::to_text(*value);
    if (std::ranges::find(axis.values, written) == axis.values.end())
      axis.values.push_back(std::move(written));
  }
  return axis;
}

}  // namespace gnomon::sweep
