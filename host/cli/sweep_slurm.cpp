// SPDX-License-Identifier: Apache-2.0
// From the command line to Slurm and, if that is waited for, back.
#include "host/cli/sweep_slurm.hpp"

#include <fmt/format.h>

#include "host/sweep/slurm.hpp"
#include "host/sweep/store.hpp"

namespace gnomon::cli {

namespace fs = std::filesystem;

void SweepSlurm::add_to(CLI::App& command, const std::vector<CLI::Option*>& others) {
  CLI::Option* slurm =
      command
          .add_option("--slurm", shards_, "Submit N shards as a Slurm job array, and their merge behind it")
          ->type_name("N")
          ->check(CLI::Range(1U, 100000U));
  for (CLI::Option* other : others) slurm->excludes(other);
  command.add_option("--slurm-option", options_, "An option for sbatch, as --slurm-option=--partition=long")
      ->needs(slurm)
      ->allow_extra_args(false);
  command.add_flag("--wait", wait_, "Return when Slurm has done it all")->needs(slurm);
}

Result<int> SweepSlurm::run(Context& context, const SlurmRequest& request) const {
  sweep::SlurmSweep job;
  job.program = fs::read_symlink("/proc/self/exe");
  job.specification = fs::absolute(request.specification);
  job.output = fs::absolute(request.output);
  job.shards = shards_;
  job.jobs = request.jobs > 0 ? request.jobs : 1;
  job.shard_flags = request.shard_flags;
  job.merge_flags = request.merge_flags;
  job.slurm_options = options_;
  job.wait = wait_;
  const auto jobs = sweep::submit(job);
  if (!jobs) return tl::make_unexpected(jobs.error());
  context.log->info("Slurm jobs {} (shards) and {} (merge)", jobs->array, jobs->merge);
  if (wait_) return finish(request);
  fmt::print("{} shards are job {}, their merge is job {}\n{}\n", shards_, jobs->array, jobs->merge,
             (request.output / "slurm").string());
  return kDone;
}

Result<int> SweepSlurm::finish(const SlurmRequest& request) const {
  const fs::path results = request.output / "results.sqlite";
  const auto store = sweep::Store::open_existing(results);
  if (!store) return tl::make_unexpected(store.error());
  std::size_t missing = request.keys.size(), failed = 0;
  for (const auto& [key, is_failed] : store->keys()) {
    if (!request.keys.contains(key)) continue;
    --missing;
    failed += is_failed ? 1 : 0;
  }
  if (missing > 0)
    return fail(fmt::format(
        "{}: error: {} of {} points are missing; {} says why, the same command again "
        "measures them",
        results.string(), missing, request.keys.size(), (request.output / "slurm" / "shard-*.log").string()));
  fmt::print("{} points from {} shards, {} failed\n{}\n", request.keys.size(), shards_, failed,
             (request.output / "report.html").string());
  return kDone;
}

}  // namespace gnomon::cli
