// SPDX-License-Identifier: Apache-2.0
// One builder at a time for each cache entry, across threads and processes.
#pragma once

#include <filesystem>

namespace gnomon::sim {

/// Holds an exclusive lock on a file (created if absent) as long as it lives. The kernel releases it when the
/// process dies.
class FileLock {
 public:
  /// Waits for the lock. Throws std::runtime_error, naming the file, if it cannot be opened.
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace gnomon::sim
