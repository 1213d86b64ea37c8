// SPDX-License-Identifier: Apache-2.0
// A directory of results that appears all at once, or not at all.
#pragma once

#include <filesystem>
#include <string>

#include "host/base/result.hpp"

namespace gnomon::report {

/// Results are written into `staging()`, a hidden sibling of the target. `commit()` puts them in place;
/// without it the destructor removes them and the target is as it was.
class OutputDirectory {
 public:
  /// Fails where the target is no directory or cannot be written, with one line that names it.
  static Result<OutputDirectory> create(const std::filesystem::path& target);

  OutputDirectory(OutputDirectory&& other) noexcept;
  OutputDirectory& operator=(OutputDirectory&&) = delete;
  ~OutputDirectory();

  const std::filesystem::path& staging() const { return staging_; }

  /// Writes `content` to `name` in the staging directory.
  Result<void> write(const std::string& name, std::string_view content) const;

  /// A target that did not exist appears by one rename. One that did is exchanged with the staging directory
  /// in one step, and what it held besides our results moves over. Where the system cannot exchange (a mount
  /// point, an old file system) or somebody works in the directory, results are renamed into it one by one,
  /// `last` at the end.
  Result<void> commit(const std::string& last);

 private:
  OutputDirectory(std::filesystem::path target, std::filesystem::path staging);
  std::filesystem::path target_, staging_;
};

}  // namespace gnomon::report
