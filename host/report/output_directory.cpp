// SPDX-License-Identifier: Apache-2.0
// A directory of results that appears all at once, or not at all.
#include "host/report/output_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>  // renameat2
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

namespace gnomon::report {
namespace fs = std::filesystem;
namespace {

/// The path itself if it exists, else the nearest directory above it that does.
fs::path nearest_existing(fs::path path) {
  std::error_code error;
  while (!path.empty() && !fs::exists(path, error)) path = path.parent_path();
  return path.empty() ? fs::path(".") : path;
}

bool is_within(const fs::path& inner, const fs::path& outer) {
  const auto [outer_end, inner_at] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return outer_end == outer.end();
}

bool exchange(const fs::path& a, const fs::path& b) {
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

/// A new hidden directory in `parent`, if that can be written.
std::optional<fs::path> make_staging(const fs::path& parent, const std::string& name) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    const fs::path staging = parent / fmt::format(".{}.gnomon-{}-{}", name, getpid(), attempt);
    if (mkdir(staging.c_str(), 0777) == 0) return staging;
    if (errno != EEXIST) break;
  }
  return std::nullopt;
}

std::vector<fs::path> entries(const fs::path& directory) {
  std::vector<fs::path> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) paths.push_back(entry.path());
  return paths;
}

/// After the exchange: what the old directory held besides results goes to the new one.
void move_foreign(const fs::path& old, const fs::path& target) {
  for (const fs::path& path : entries(old)) {
    const fs::path to = target / path.filename();
    if (!fs::exists(fs::symlink_status(to))) fs::rename(path, to);
  }
}

void move_one_by_one(const fs::path& staging, const fs::path& target, const std::string& last) {
  fs::remove(target / last);  // whoever finds it finds a complete set
  for (const fs::path& path : entries(staging)) {
    if (path.filename() == last) continue;
    // A directory takes no place that is not empty.
    if (fs::is_directory(path)) fs::remove_all(target / path.filename());
    fs::rename(path, target / path.filename());
  }
  if (fs::exists(staging / last)) fs::rename(staging / last, target / last);
}

}  // namespace

OutputDirectory::OutputDirectory(fs::path target, fs::path staging)
    : target_(std::move(target)), staging_(std::move(staging)) {}

OutputDirectory::OutputDirectory(OutputDirectory&& other) noexcept
    : target_(std::move(other.target_)), staging_(std::exchange(other.staging_, {})) {}

OutputDirectory::~OutputDirectory() {
  std::error_code ignored;
  if (!staging_.empty()) fs::remove_all(staging_, ignored);
}

Result<OutputDirectory> OutputDirectory::create(const fs::path& target) {
  if (target.empty()) return fail("output directory: empty name, expected a path");
  std::error_code error;
  // Absolute first: of a relative path that does not exist yet, weakly_canonical keeps it relative.
  const fs::path full = fs::weakly_canonical(fs::absolute(target, error), error);
  if (error) return fail(fmt::format("{}: {}", target.string(), error.message()));
  if (fs::exists(full, error) && !fs::is_directory(full, error)) {
    return fail(fmt::format("{}: is not a directory, expected one to write the results to", target.string()));
  }
  // Beside the target, so that a rename is enough; where the target lacks parents, beside the first of them
  // that is missing.
  const fs::path existing = nearest_existing(full);
  const fs::path parent = existing == full && full.has_parent_path() ? full.parent_path() : existing;
  if (!fs::is_directory(parent, error)) {
    return fail(fmt::format("{}: {} is not a directory", target.string(), parent.string()));
  }
  if (existing == full && access(full.c_str(), W_OK | X_OK) != 0) {
    return fail(fmt::format("{}: {}, expected a directory that can be written", target.string(),
                            std::strerror(errno)));
  }
  if (auto staging = make_staging(parent, full.filename().string())) return OutputDirectory(full, *staging);
  // A directory of ours in one that is not: inside is good enough, results then move one by one.
  if (existing == full) {
    if (auto staging = make_staging(full, "results")) return OutputDirectory(full, *staging);
  }
  return fail(fmt::format("{}: cannot write in {}", target.string(), parent.string()));
}

Result<void> OutputDirectory::write(const std::string& name, std::string_view content) const {
  std::ofstream file(staging_ / name, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file)
    return fail(fmt::format("{}: cannot write {}: {}", target_.string(), name, std::strerror(errno)));
  return {};
}

Result<void> OutputDirectory::commit(const std::string& last) try {
  if (!fs::exists(target_)) {
    fs::create_directories(target_.parent_path());
    fs::rename(staging_, target_);
    staging_.clear();
    return {};
  }
  fs::permissions(staging_, fs::status(target_).permissions());
  const bool occupied = is_within(fs::current_path(), target_);
  if (!occupied && exchange(staging_, target_)) {
    move_foreign(staging_, target_);
  } else {
    move_one_by_one(staging_, target_, last);
  }
  return {};
} catch (const fs::filesystem_error& error) {
  return fail(fmt::format("{}: {}", target_.string(), error.code().message()));
}

}  // namespace gnomon::report
