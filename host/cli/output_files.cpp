// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all.
#include "host/cli/output_files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace gnomon::cli {
namespace {

std::filesystem::path directory_of(const std::filesystem::path& target) {
  return target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
}

std::filesystem::path temporary_for(const std::filesystem::path& target) {
  // The extension stays: some libraries look at it.
  return directory_of(target) /
         fmt::format(".{}.{}{}", target.stem().string(), getpid(), target.extension().string());
}

}  // namespace

Result<void> check_output(const std::filesystem::path& target) {
  std::error_code ignored;
  if (std::filesystem::is_directory(target, ignored))
    return fail(target.string() + ": error: is a directory, expected a file name");
  const std::filesystem::path directory = directory_of(target);
  if (!std::filesystem::is_directory(directory, ignored)) {
    return fail(fmt::format("{}: error: cannot be written: {} is not a directory", target.string(),
                            directory.string()));
  }
  if (access(directory.c_str(), W_OK | X_OK) != 0) {
    return fail(fmt::format("{}: error: cannot be written: {}", target.string(), std::strerror(errno)));
  }
  return {};
}

OutputFiles::~OutputFiles() {
  std::error_code ignored;
  for (const File& file : files_) std::filesystem::remove(file.temporary, ignored);
}

Result<void> OutputFiles::add(const std::filesystem::path& target,
                              const std::function<Result<void>(const std::filesystem::path&)>& write) {
  if (Result<void> possible = check_output(target); !possible) return possible;
  files_.push_back({temporary_for(target), target});
  if (Result<void> written = write(files_.back().temporary); !written) {
    return fail(target.string() + ": error: cannot be written: " + written.error().message);
  }
  return {};
}

Result<void> OutputFiles::commit() {
  for (const File& file : files_) {
    std::error_code problem;
    std::filesystem::rename(file.temporary, file.target, problem);
    if (problem) return fail(file.target.string() + ": error: cannot be written: " + problem.message());
  }
  files_.clear();
  return {};
}

Result<void> write_bytes(const std::filesystem::path& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) return fail(std::strerror(errno));
  return {};
}

}  // namespace gnomon::cli
