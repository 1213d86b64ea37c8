// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "host/base/result.hpp"

namespace gnomon::cli {

/// Every file is written under a temporary name beside its target; commit() renames them all. What was not
/// committed is removed by the destructor.
class OutputFiles {
 public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Calls `write` with the temporary path. Fails, naming `target`, where its directory is missing or cannot
  /// be written or where it is a directory itself; and with what `write` says.
  Result<void> add(const std::filesystem::path& target,
                   const std::function<Result<void>(const std::filesystem::path&)>& write);
  Result<void> commit();

 private:
  struct File {
    std::filesystem::path temporary, target;
  };
  std::vector<File> files_;
};

/// Whether `target` could be written, before hours are spent on its content.
Result<void> check_output(const std::filesystem::path& target);

/// Writes `content` to `path`; fails with the reason, without naming the (temporary) path.
Result<void> write_bytes(const std::filesystem::path& path, std::string_view content);

}  // namespace gnomon::cli
