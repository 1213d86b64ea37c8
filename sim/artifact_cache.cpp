// SPDX-License-Identifier: Apache-2.0
// Entries are built in a folder beside their own and renamed when complete.
#include "sim/artifact_cache.hpp"

#include <fstream>
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

}  // namespace

ArtifactCache::ArtifactCache(fs::path directory) : directory_(std::move(directory)) {
  create_folder(directory_ / "locks");
}

fs::path ArtifactCache::entry(const Artifact& artifact) const {
  return directory_ / (artifact.kind + "-" + content_hash(artifact.manifest));
}

bool ArtifactCache::intact(const Artifact& artifact) const {
  const fs::path folder = entry(artifact);
  if (!fs::exists(folder / kManifest) || !fs::exists(folder / artifact.product)) return false;
  return read_file(folder / kManifest) == seal(artifact, folder / artifact.product);
}

ArtifactCache::Found ArtifactCache::get(const Artifact& artifact, const Build& build) const {
  const fs::path folder = entry(artifact);
  if (intact(artifact)) return {folder / artifact.product, false};

  const FileLock lock(directory_ / "locks" / folder.filename());
  if (intact(artifact)) return {folder / artifact.product, false};

  // Only the holder of the lock writes here, so whatever lies here was left by a builder that died.
  const fs::path work = folder.string() + ".building";
  fs::remove_all(work);
  create_folder(work);
  try {
    build(work);
  } catch (...) {
    fs::remove_all(work);
    throw;
  }
  std::ofstream(work / kManifest, std::ios::binary) << seal(artifact, work / artifact.product);
  fs::remove_all(folder);
  fs::rename(work, folder);
  return {folder / artifact.product, true};
}

}  // namespace gnomon::sim
