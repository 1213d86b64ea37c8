// SPDX-License-Identifier: Apache-2.0
// gnomon verify --baseline: figures of scenes against those that are kept with the sources.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/cli/junit.hpp"
#include "host/regression/baseline.hpp"
#include "host/regression/difference.hpp"

namespace gnomon::cli {

struct BaselineOptions {
  std::filesystem::path file;
  std::vector<std::filesystem::path> scenes;  ///< none: those of the file
  std::vector<std::string> set;               ///< none: those of the file
  std::vector<std::string> defines;
  bool update = false;  ///< write the file instead of comparing with it
  bool json = false;
};

/// What came of one scene.
struct BaselineVerdict {
  std::string scene;
  std::uint64_t words = 0;
  std::string failure;  ///< why the hardware is not golden; empty: it is
  regression::Comparison comparison;
  double seconds = 0;

  bool passed() const { return failure.empty() && comparison.differences.empty(); }
};

/// Measures every scene and prints what came of it. Fails before anything is measured if the file cannot be
/// read, holds a scene not, or was measured with another configuration. Where a word differs from golden's
/// the file is not updated. A comparison of no figure has not passed.
Result<std::vector<BaselineVerdict>> check_baseline(Context& context, const BaselineOptions& options);

/// Scene by scene: words, figures, and the differences with what was and what is.
nlohmann::ordered_json to_json(const std::vector<BaselineVerdict>& verdicts);

/// What differs is the failure's text.
TestCase test_case(const BaselineVerdict& verdict);

}  // namespace gnomon::cli
