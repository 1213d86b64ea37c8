// SPDX-License-Identifier: Apache-2.0
// sbatch is all of Slurm that is used: what it cannot do, another scheduler need not do either.
#include "host/sweep/slurm.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "host/report/numbers.hpp"
#include "sim/process.hpp"

namespace gnomon::sweep {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const SlurmSweep& sweep) {
  return sweep.output / "slurm";
}

std::vector<std::string> command_of(const SlurmSweep& sweep) {
  return {sweep.program.string(), "sweep", sweep.specification.string(), "-o", sweep.output.string(), "-q"};
}

std::string script(const std::string& says, const std::string& command) {
  return fmt::format("#!/bin/sh\n# Written by gnomon sweep --slurm: {}.\nexec {}\n", says, command);
}

Result<void> write(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (file << text << std::flush) return {};
  return fail(fmt::format("{}: cannot be written", path.string()));
}

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What sbatch says: the job's number, or why not.
Result<std::string> sbatch(const SlurmSweep& sweep, std::vector<std::string> arguments,
                           const std::string& job_script) {
  std::vector<std::string> words{"sbatch", "--parsable"};
  words.insert(words.end(), sweep.slurm_options.begin(), sweep.slurm_options.end());
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.push_back(job_script);
  const fs::path said = folder_of(sweep) / "sbatch.txt";
  fs::remove(said);
  bool done = false;
  try {
    done = sim::Process(words, folder_of(sweep), said).succeeded();
  } catch (const std::runtime_error&) {
    return fail("--slurm: sbatch is not there; Debian's package is slurm-client");
  }
  const std::string text = content_of(said);
  const std::string line = text.substr(0, text.find('\n'));
  // A cluster's name may follow the number. A job that was waited for and failed has a number all the same.
  const std::string number = line.substr(0, line.find(';'));
  if (!number.empty() && number.find_first_not_of("0123456789") == std::string::npos) return number;
  return fail(fmt::format("--slurm: {}", done || line.empty() ? "sbatch gave no job number" : line));
}

}  // namespace

std::string shard_script(const SlurmSweep& sweep) {
  std::vector<std::string> words = command_of(sweep);
  words.insert(words.end(), {"-j", std::to_string(sweep.jobs)});
  words.insert(words.end(), sweep.shard_flags.begin(), sweep.shard_flags.end());
  return script("a task measures one shard", fmt::format("{} --shard \"$SLURM_ARRAY_TASK_ID/{}\"",
                                                         report::shell_line(words), sweep.shards));
}

std::string merge_script(const SlurmSweep& sweep) {
  std::vector<std::string> words = command_of(sweep);
  words.emplace_back("--merge");
  words.insert(words.end(), sweep.merge_flags.begin(), sweep.merge_flags.end());
  return script("all shards into one table", report::shell_line(words));
}

Result<SlurmJobs> submit(const SlurmSweep& sweep) {
  const fs::path folder = folder_of(sweep);
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) return fail(fmt::format("{}: cannot be made: {}", folder.string(), problem.message()));
  if (auto done = write(folder / "shard.sh", shard_script(sweep)); !done) return fail(done.error().message);
  if (auto done = write(folder / "merge.sh", merge_script(sweep)); !done) return fail(done.error().message);
  // What was done before a node was lost is in the shard's file: the task may simply start again.
  const auto array = sbatch(sweep,
                            {"--job-name=gnomon-sweep", "--requeue", "--open-mode=append",
                             fmt::format("--array=1-{}", sweep.shards),
                             fmt::format("--cpus-per-task={}", sweep.jobs), "--output=shard-%a.log"},
                            "shard.sh");
  if (!array) return fail(array.error().message);
  std::vector<std::string> arguments{"--job-name=gnomon-merge", "--requeue", "--open-mode=append",
                                     fmt::format("--dependency=afterany:{}", *array), "--output=merge.log"};
  if (sweep.wait) arguments.emplace_back("--wait");
  const auto merge = sbatch(sweep, arguments, "merge.sh");
  if (!merge) return fail(merge.error().message);
  return SlurmJobs{*array, *merge};
}

}  // namespace gnomon::sweep
