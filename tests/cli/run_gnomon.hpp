// SPDX-License-Identifier: Apache-2.0
// Runs the gnomon program as a user would.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::test {

struct Outcome {
  int status = -1;  ///< exit status; 128 + n if signal n ended it
  std::string out, err;
};

struct HowToRun {
  std::vector<std::string> environment;                   ///< "NAME=value", added to this process's
  std::filesystem::path directory;                        ///< working directory; empty: this process's
  bool as_nobody = false;                                 ///< without root's rights
  std::optional<std::chrono::milliseconds> interrupt_at;  ///< SIGINT after so much CPU time of the program
  std::function<bool()> interrupt_when;                   ///< SIGINT as soon as it says so
};

/// Runs `gnomon arguments...` to its end. Throws std::system_error if it cannot be started.
Outcome run_gnomon(const std::vector<std::string>& arguments, const HowToRun& how = {});

/// Number of lines, whether or not the last one is ended.
std::size_t line_count(const std::string& text);

}  // namespace gnomon::test
