// SPDX-License-Identifier: Apache-2.0
// A sweep's shards as a Slurm job array with a merge behind it. Protocol: docs/cluster.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"

namespace gnomon::sweep {

/// What is to be submitted. Paths are absolute and mean the same on every node.
struct SlurmSweep {
  std::filesystem::path program;           ///< gnomon itself
  std::filesystem::path specification;     ///< as after "gnomon sweep"
  std::filesystem::path output;            ///< there; job scripts and logs go to its folder slurm
  unsigned shards = 1;                     ///< tasks of the array
  unsigned jobs = 1;                       ///< points at a time, and processors asked for, a task
  std::vector<std::string> shard_flags;    ///< handed on to every shard
  std::vector<std::string> merge_flags;    ///< handed on to the merge
  std::vector<std::string> slurm_options;  ///< handed on to sbatch, for both
  bool wait = false;                       ///< submit() returns when the merge has ended
};

/// The script of the array: one task measures one shard.
std::string shard_script(const SlurmSweep& sweep);
/// The script of the merge.
std::string merge_script(const SlurmSweep& sweep);

/// Numbers of the jobs.
struct SlurmJobs {
  std::string array, merge;
};

/// Writes the scripts and submits both. Fails where sbatch is not there or refuses, with what it says.
Result<SlurmJobs> submit(const SlurmSweep& sweep);

}  // namespace gnomon::sweep
