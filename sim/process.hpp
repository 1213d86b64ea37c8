// SPDX-License-Identifier: Apache-2.0
// Runs another program with its output in a file.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::sim {

/// A running program; waited for on destruction.
class Process {
 public:
  /// Starts `arguments` (the first is looked up in PATH) in folder `directory`; both outputs are appended to
  /// `log`. Throws std::runtime_error if it cannot be started.
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& directory,
          const std::filesystem::path& log);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Whether it ended with exit code 0.
  bool succeeded();

 private:
  pid_t pid_ = -1;
  int status_ = -1;
};

}  // namespace gnomon::sim
