// SPDX-License-Identifier: Apache-2.0
// The options of gnomon sweep that hand the work to Slurm (docs/cluster.md).
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/command.hpp"

namespace gnomon::cli {

/// The sweep that is to be handed on.
struct SlurmRequest {
  std::filesystem::path specification, output;
  unsigned jobs = 0;  ///< 0: one point at a time
  std::vector<std::string> shard_flags, merge_flags;
  std::set<std::string> keys;  ///< of all points
};

class SweepSlurm {
 public:
  /// --slurm, --slurm-option and --wait; --slurm excludes those of `others`.
  void add_to(CLI::App& command, const std::vector<CLI::Option*>& others);
  bool asked() const { return shards_ > 0; }
  /// Submits the shards and the merge and says so; with --wait, returns when all is done, and fails where
  /// points are missing.
  Result<int> run(Context& context, const SlurmRequest& request) const;

 private:
  Result<int> finish(const SlurmRequest& request) const;

  unsigned shards_ = 0;
  std::vector<std::string> options_;
  bool wait_ = false;
};

}  // namespace gnomon::cli
