// SPDX-License-Identifier: Apache-2.0
// Where models are made from, with what, and where they are kept.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::sim {

/// Sources, tools and folders of a model cache.
struct Toolchain {
  std::filesystem::path cache_dir;
  std::filesystem::path prebuilt_dir;  ///< looked into first and never written; need not exist
  std::filesystem::path rtl_dir;       ///< holds gnomon.f
  std::string verilator;
  std::string verilator_root;         ///< its include/ holds the runtime
  std::vector<std::string> compiler;  ///< C++ compiler, with a launcher in front if there is one

  /// As found when this program was built, changed by the environment: GNOMON_CACHE_DIR (else
  /// XDG_CACHE_HOME/gnomon, else
  /// ~/.cache/gnomon), GNOMON_RTL_DIR, VERILATOR, VERILATOR_ROOT, GNOMON_CXX. Throws std::runtime_error if no
  /// folder for the cache can be named.
  static Toolchain from_environment();

  /// One line a tool: name and version. Throws std::runtime_error if one does not run.
  std::string versions() const;
};

/// The first line of what `program --version` says, with its end. Throws std::runtime_error if it does not
/// run.
std::string version_of(const std::string& program);

}  // namespace gnomon::sim
