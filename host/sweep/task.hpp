// SPDX-License-Identifier: Apache-2.0
// A point that is to be measured, and which of them share a scene. Theory: docs/sweep.md, "Shared work".
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/sweep/points.hpp"
#include "host/sweep/store.hpp"

namespace gnomon::sweep {

struct Task {
  Point point;
  std::string key;
  std::filesystem::path scene;
};

/// The row of a point that nothing is known of yet, finished now.
Row row_of(const Task& task);

/// Points that differ in their technique's parameters alone are together; groups in the order of their first
/// point. What is pointed at is `tasks`.
std::vector<std::vector<const Task*>> groups_of(const std::vector<Task>& tasks);

/// True for parameters that a technique or the system alone looks at: what is not shared between points.
bool of_technique(const config::Parameter& parameter);

/// UTC, ISO 8601.
std::string now();

}  // namespace gnomon::sweep
