// SPDX-License-Identifier: Apache-2.0
// Single entries of a scene file, checked.
#include "host/scene/entries.hpp"

#include <fmt/format.h>

#include <cmath>

namespace gnomon::scene {
namespace {

/// As it would be written; JSON has no text for what is not finite.
std::string shown(const nlohmann::json& value) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    return fmt::format("{}", value.get<double>());
  return value.dump();
}

}  // namespace

using config::Document;

std::string key_of(const Pointer& entry) {
  return entry.to_string().substr(1);
}

bool has(const Document& document, const Pointer& table, const char* key) {
  return document.root().at(table).contains(key);
}

Result<void> expect(const Document& document, const Pointer& at, bool (nlohmann::json::*is)() const noexcept,
                    std::string_view kind) {
  if ((document.root().at(at).*is)()) return {};
  return document.refuse(at, fmt::format("{} is not {}", key_of(at), kind));
}

Result<double> read_number(const Document& document, const Pointer& at) {
  const nlohmann::json& value = document.root().at(at);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    return document.refuse(at, fmt::format("{} = {} is not a finite number", key_of(at), shown(value)));
  return value.get<double>();
}

Result<std::string> read_text(const Document& document, const Pointer& at) {
  const nlohmann::json& value = document.root().at(at);
  if (!value.is_string() || value.get<std::string>().empty())
    return document.refuse(at, fmt::format("{} = {} is not a text", key_of(at), shown(value)));
  return value.get<std::string>();
}

Result<bool> read_flag(const Document& document, const Pointer& at) {
  if (Result<void> flag = expect(document, at, &nlohmann::json::is_boolean, "true or false"); !flag)
    return tl::make_unexpected(flag.error());
  return document.root().at(at).get<bool>();
}

Result<Vec3> read_vector(const Document& document, const Pointer& at) {
  const nlohmann::json& value = document.root().at(at);
  if (!value.is_array() || value.size() != 3)
    return document.refuse(at,
                           fmt::format("{} = {} is not a list of three numbers", key_of(at), shown(value)));
  Vec3 vector;
  for (unsigned i = 0; i < 3; ++i) {
    const Result<double> component = read_number(document, at / i);
    if (!component) return tl::make_unexpected(component.error());
    vector[static_cast<int>(i)] = *component;
  }
  return vector;
}

}  // namespace gnomon::scene
