// SPDX-License-Identifier: Apache-2.0
// Entries are built in a folder beside their own and renamed when complete.
#include "sim/artifact_cache.hpp"

#include <stdexcept>
#include <system_error>

#include "sim/content_hash.hpp"
#include "sim/file_lock.hpp"

namespace gnomon::sim {

namespace fs = std::filesystem;

namespace {

constexpr const char* kManifest = "manifest.txt";

std::string seal(const Artifact& artifact, const fs::path& product) {
  return artifact.manifest + "\nproduct " + content_hash(read_file(product)) + "\n";
}

void create_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw std::runtime_error("cannot create " + path.string() + ": " + error.message());
}

std::string entry_name(const Artifact& artifact) {
  return artifact.kind + "-" + content_hash(artifact.manifest);
}

}  // namespace

std::optional<fs::path> find_artifact(const fs::path& directory, const Artifact& artifact) {
  const fs::path folder = directory / entry_name(artifact);
  const fs::path product = folder / artifact.product;
  if (!fs::exists(folder / kManifest) || !fs::exists(product)) return std::nullopt;
  if (read_file(folder / kManifest) != seal(artifact, product)) return std::nullopt;
  return product;
}

ArtifactCache::ArtifactCache(fs::path directory) : directory_(std::move(directory)) {
  create_folder(directory_ / "locks");
}

fs::path ArtifactCache::entry(const Artifact& artifact) const {
  return directory_ / entry_name(artifact);
}

ArtifactCache::Found ArtifactCache::get(const Artifact& artifact, const Build& build) const {
  if (const auto product = find_artifact(directory_, artifact)) return {*product, false};

  const FileLock lock(directory_ / "locks" / entry_name(artifact));
  if (const auto product = find_artifact(directory_, artifact)) return {*product, false};

  // Only the holder of the lock writes here, so whatever lies here was left by a builder that died.
  const fs::path folder = entry(artifact);
  const fs::path work = folder.string() + ".building";
  fs::remove_all(work);
  create_folder(work);
  try {
    build(work);
    write_file(work / kManifest, seal(artifact, work / artifact.product));
  } catch (...) {
    fs::remove_all(work);
    throw;
  }
  fs::remove_all(folder);
  fs::rename(work, folder);
  return {folder / artifact.product, true};
}

}  // namespace gnomon::sim
