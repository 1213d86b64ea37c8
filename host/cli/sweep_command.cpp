// SPDX-License-Identifier: Apache-2.0
// gnomon sweep: many configurations, one table, one report.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <nlohmann/json.hpp>

#include "host/cli/command.hpp"
#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/run_settings.hpp"
#include "host/cli/scene_input.hpp"
#include "host/cli/sweep_area.hpp"
#include "host/cli/sweep_slurm.hpp"
#include "host/cli/sweep_tasks.hpp"
#include "host/cli/versions.hpp"
#include "host/scene/scene_file.hpp"
#include "host/sweep/figures.hpp"
#include "host/sweep/page.hpp"
#include "host/sweep/plots.hpp"
#include "host/sweep/runner.hpp"
#include "host/sweep/selection.hpp"
#include "host/sweep/spec.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

class SweepCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("sweep", "Error against run time over many configurations");
    command->add_option("SPEC", spec_, "What to sweep (.toml, .json; docs/sweep.md)")->required();
    command->add_option("-o,--output", output_, "Directory of the results [out/<name of SPEC>]")
        ->type_name("DIR");
    command->add_option("-j,--jobs", jobs_, "Points at a time [one a core]")->check(CLI::Range(1U, 1024U));
    command
        ->add_option("--engine", engine_,
                     "golden: the model alone; rtl, system: the hardware, checked against golden")
        ->check(CLI::IsMember({"golden", "rtl", "system"}))
        ->capture_default_str();
    CLI::Option* shard =
        command->add_option("--shard", shard_, "Measure every n-th point only, into a file of its own")
            ->type_name("I/N");
    CLI::Option* merge = command->add_flag("--merge", merge_,
                                           "Take the files of all shards into the results, measure nothing");
    merge->excludes(shard);
    CLI::Option* confirm =
        command
            ->add_option(
                "--confirm", confirm_,
                "Run points on the rtl engine too and compare cycles and words: front, all, or how many")
            ->type_name("WHICH")
            ->excludes(shard);
    command->add_flag("--retry", retry_, "Measure points again that failed");
    command->add_flag("--extend", extend_, "Add to the results of another specification");
    command->add_flag("--plots", plots_, "Write every plot as SVG and PNG into the folder plots");
    command->add_flag("--json", json_, "Print how many points were measured as JSON");
    area_.add_to(*command, {shard});
    slurm_.add_to(*command, {shard, merge, confirm, command->get_option("--area")});
    command->footer("Example:\n  gnomon sweep scenes/sweeps/widths.toml -o out/widths");
    return command;
  }

  Result<int> run(Context& context) override {
    const Result<Shard> shard = Shard::parse(shard_);
    if (!shard) return tl::make_unexpected(shard.error());
    const auto selection = sweep::Selection::parse(confirm_);
    if (!selection) return tl::make_unexpected(selection.error());
    const Result<sweep::Spec> spec = sweep::read_spec(spec_);
    if (!spec) return tl::make_unexpected(spec.error());
    const auto all = tasks_of(*spec);
    if (!all) return tl::make_unexpected(all.error());
    if (output_.empty()) output_ = fs::path("out") / fs::path(spec_).stem();
    std::error_code problem;
    fs::create_directories(output_, problem);
    if (problem) return fail(fmt::format("{}: cannot be made: {}", output_.string(), problem.message()));
    auto store = sweep::Store::open(output_ / shard->file(), record_of(*spec), extend_);
    if (!store) return tl::make_unexpected(store.error());
    if (slurm_.asked()) return slurm_.run(context, slurm_request(*all));
    if (merge_) {
      if (auto merged = merge(context, *store); !merged) return tl::make_unexpected(merged.error());
    }
    return finish(context, {*spec, *all, *shard, *selection}, *store);
  }

 private:
  /// Another engine's results are those of another specification.
  sweep::SweepRecord record_of(const sweep::Spec& spec) const {
    const std::string engine = engine_ == "golden" ? "" : fmt::format("# --engine {}\n", engine_);
    return {spec.name, engine + spec.text, versions().front().second, sweep::now()};
  }

  SlurmRequest slurm_request(const std::vector<sweep::Task>& all) const {
    SlurmRequest request{spec_, output_, jobs_, {"--engine", engine_}, {"--engine", engine_}, {}};
    if (retry_) request.shard_flags.emplace_back("--retry");
    if (extend_) {
      request.shard_flags.emplace_back("--extend");
      request.merge_flags.emplace_back("--extend");
    }
    if (plots_) request.merge_flags.emplace_back("--plots");
    for (const sweep::Task& task : all) request.keys.insert(task.key);
    return request;
  }

  Result<void> merge(Context& context, sweep::Store& store) const {
    std::size_t files = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(output_)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with("shard-") || entry.path().extension() != ".sqlite") continue;
      const auto shard = sweep::Store::open_existing(entry.path());
      if (!shard) return tl::make_unexpected(shard.error());
      const auto counts = store.merge(*shard);
      if (!counts) return fail(fmt::format("{}: error: {}", entry.path().string(), counts.error().message));
      context.log->info("{}: {} new, {} known", name, counts->added + counts->replaced, counts->known);
      ++files;
    }
    if (files == 0) return fail(fmt::format("{}: error: holds no shards", output_.string()));
    return {};
  }

  std::vector<sweep::Task> missing(const std::vector<sweep::Task>& all, const Shard& shard,
                                   const sweep::Store& store) const {
    const std::map<std::string, bool> known = store.keys();
    std::vector<sweep::Task> tasks;
    for (std::size_t i = shard.index; i < all.size(); i += shard.count) {
      const auto at = known.find(all[i].key);
      if (at == known.end() || (retry_ && at->second)) tasks.push_back(all[i]);
    }
    return tasks;
  }

  sweep::RunnerOptions runner_options(Context& context) const {
    sweep::RunnerOptions options;
    options.jobs = jobs_;
    options.task.engine = *pipeline::engine_of(engine_);
    options.task.load = [](const fs::path& path, const config::Settings& settings) {
      return scene::load_scene(path, scene_options(settings));
    };
    options.task.settings = run_settings;
    options.task.abort = &context.interruption.flag();
    return options;
  }

  using Run = sweep::RunnerCounts(const std::vector<sweep::Task>&, sweep::Store&,
                                  const sweep::RunnerOptions&);

  sweep::RunnerCounts each(Context& context, const char* what, const std::vector<sweep::Task>& tasks,
                           sweep::Store& store, Run* go) const {
    ProgressLine line(context.show_progress);
    sweep::RunnerOptions options = runner_options(context);
    options.progress = [&](std::size_t done, std::size_t all) {
      line.update(what, static_cast<double>(done) / static_cast<double>(all));
    };
    const sweep::RunnerCounts counts = go(tasks, store, options);
    if (counts.interrupted) throw Interrupted();
    return counts;
  }

  /// What a sweep is to do.
  struct Job {
    const sweep::Spec& spec;
    const std::vector<sweep::Task>& all;
    const Shard& shard;
    const sweep::Selection& selection;
  };
  struct Outcome {
    std::size_t left = 0;
    double seconds = 0;
    sweep::RunnerCounts measured, confirmed;
    SweepArea::Counts area;

    std::size_t flagged() const { return measured.flagged + confirmed.failed; }
  };

  Result<int> finish(Context& context, const Job& job, sweep::Store& store) const {
    Outcome outcome;
    const std::vector<sweep::Task> tasks = missing(job.all, job.shard, store);
    const auto start = std::chrono::steady_clock::now();
    if (!merge_) outcome.measured = each(context, "points", tasks, store, sweep::run_tasks);
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.left = tasks.size() - outcome.measured.done - outcome.measured.failed;
    if (!job.selection.empty()) {
      const std::set<std::string> chosen = job.selection.choose(store.rows());
      std::vector<sweep::Task> some;
      std::ranges::copy_if(job.all, std::back_inserter(some),
                           [&](const sweep::Task& task) { return chosen.contains(task.key); });
      outcome.confirmed = each(context, "confirming", some, store, sweep::confirm_tasks);
    }
    if (area_.asked()) {
      const auto area = area_.run(context, job.all, store, jobs_);
      if (!area) return tl::make_unexpected(area.error());
      outcome.area = *area;
    }
    if (job.shard.count == 1) {
      if (auto done = write_report(context, job.spec.name, store.rows()); !done)
        return tl::make_unexpected(done.error());
    }
    print(job, outcome);
    return outcome.flagged() > 0 ? kComparisonFailed : kDone;
  }

  Result<void> write_report(Context& context, const std::string& name,
                            const std::vector<sweep::Row>& rows) const {
    OutputFiles files;
    for (const auto& [file, content] : {std::pair{"report.html", sweep::sweep_page(name, rows)},
                                        std::pair{"points.csv", sweep::csv_table(rows)}}) {
      if (auto done = files.add(output_ / file,
                                [&text = content](const fs::path& path) { return write_bytes(path, text); });
          !done)
        return done;
    }
    if (plots_) {
      const auto drawn = sweep::write_plots(sweep::plots_of(rows), output_ / "plots");
      if (!drawn) return tl::make_unexpected(drawn.error());
      if (!*drawn)
        context.log->warn("plots: no PNG files without rsvg-convert (Debian package librsvg2-bin)");
    }
    return files.commit();
  }

  void print(const Job& job, const Outcome& outcome) const {
    const sweep::RunnerCounts &counts = outcome.measured, &confirmed = outcome.confirmed;
    const std::size_t measured = counts.done + counts.failed;
    const double rate = outcome.seconds > 0 ? static_cast<double>(measured) / outcome.seconds : 0;
    const fs::path result = output_ / (job.shard.count == 1 ? "report.html" : job.shard.file());
    if (json_) {
      const nlohmann::ordered_json figures{
          {"points", job.all.size()},     {"measured", counts.done},
          {"failed", counts.failed},      {"missing", outcome.left},
          {"seconds", outcome.seconds},   {"points_per_second", rate},
          {"scenes", counts.scenes},      {"confirmed", confirmed.done},
          {"flagged", outcome.flagged()}, {"area_points", outcome.area.points},
          {"output", result.string()}};
      fmt::print("{}\n", figures.dump(2));
      return;
    }
    fmt::print("{} of {} points measured in {:.1f} s ({:.1f} a second), {} failed, {} missing\n", measured,
               job.all.size(), outcome.seconds, rate, counts.failed, outcome.left);
    if (!job.selection.empty())
      fmt::print("{} points confirmed on the hardware, {} flagged\n", confirmed.done, confirmed.failed);
    if (counts.flagged > 0)
      fmt::print("{} points measured on the hardware are flagged: the cycle model disagrees\n",
                 counts.flagged);
    if (area_.asked())
      fmt::print("{} points with an area, of {} units; {} of them estimated now\n", outcome.area.points,
                 outcome.area.units, outcome.area.runs);
    fmt::print("{}\n", result.string());
  }

  SweepArea area_;
  SweepSlurm slurm_;
  fs::path spec_, output_;
  unsigned jobs_ = 0;
  std::string engine_ = "golden", shard_, confirm_;
  bool merge_ = false, retry_ = false, extend_ = false, plots_ = false, json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_sweep_command() {
  return std::make_unique<SweepCommand>();
}

}  // namespace gnomon::cli
