// SPDX-License-Identifier: Apache-2.0
// A folder of built files, each found again by a manifest of all it was made from.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace gnomon::sim {

/// What to find or build.
struct Artifact {
  std::string kind;      ///< first part of the entry's name
  std::string manifest;  ///< text naming everything the product depends on; equal text means equal product
  std::string product;   ///< the file that `build` leaves in the folder it is given
};

/// The product of the artifact's entry in a cache folder, if it is there and undamaged. Writes nothing.
std::optional<std::filesystem::path> find_artifact(const std::filesystem::path& directory,
                                                   const Artifact& artifact);

/// Safe to use from several processes and threads at once: an entry appears whole or not at all, and one
/// builder makes it while the others wait. An entry that was damaged is made again.
class ArtifactCache {
 public:
  using Build = std::function<void(const std::filesystem::path& work_dir)>;

  /// Throws std::runtime_error if the folder cannot be created.
  explicit ArtifactCache(std::filesystem::path directory);

  struct Found {
    std::filesystem::path product;
    bool built = false;  ///< by this call
  };
  /// The artifact's product; `build` is called if there is none. Whatever `build` throws is passed on, and
  /// nothing is kept.
  Found get(const Artifact& artifact, const Build& build) const;

  /// The folder that holds an artifact's files.
  std::filesystem::path entry(const Artifact& artifact) const;

 private:
  std::filesystem::path directory_;
};

}  // namespace gnomon::sim
