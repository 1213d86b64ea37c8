// SPDX-License-Identifier: Apache-2.0
// The points of a sweep, and which of them one shard measures (docs/sweep.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/sweep/spec.hpp"
#include "host/sweep/task.hpp"

namespace gnomon::cli {

/// A sweep's results in its directory.
inline constexpr const char* kSweepResults = "results.sqlite";

/// "i/n" of --shard; all of them by default.
struct Shard {
  std::size_t index = 0;  ///< from 0
  std::size_t count = 1;

  /// "" is all.
  static Result<Shard> parse(const std::string& text);
  /// The name of its results.
  std::string file() const;
};

/// All points of the specification with their keys. Fails where a scene cannot be read.
Result<std::vector<sweep::Task>> tasks_of(const sweep::Spec& spec);

}  // namespace gnomon::cli
