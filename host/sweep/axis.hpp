// SPDX-License-Identifier: Apache-2.0
// One axis of a sweep: a parameter and the values it takes. Theory: docs/sweep.md, "Specification".
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/config/document.hpp"

namespace gnomon::sweep {

struct Axis {
  std::string key;
  std::vector<std::string> values;  ///< as they would be written after --set key=; distinct, at least one
};

/// The value at `at` as it would be written after --set: a number, a word, or three numbers.
/// Fails where it is no value of that parameter.
Result<std::string> read_value(const config::Document& document, const config::Document::Pointer& at,
                               const std::string& key);

/// The axis at `at`: a list of values, or a table {from, to[, step]} or {from, to, count[, scale]}.
Result<Axis> read_axis(const config::Document& document, const config::Document::Pointer& at,
                       const std::string& key);

}  // namespace gnomon::sweep
