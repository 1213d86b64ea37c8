// SPDX-License-Identifier: Apache-2.0
// gnomon slb: the silhouette-line buffer unit alone, on polygons.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>

#include "host/cli/output_files.hpp"
#include "host/cli/scene_input.hpp"
#include "host/cli/shadow_jobs.hpp"
#include "host/cli/slb_figures.hpp"
#include "host/cli/slb_report.hpp"
#include "host/report/numbers.hpp"
#include "host/slb/loop_stream.hpp"
#include "host/slb/query_file.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

class SlbCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("slb", "Ask the silhouette-line buffer about polygons");
    command->add_option("--loops", loops_, "Casters as polygon loops (JSON)")
        ->type_name("FILE.json")
        ->required();
    CLI::Option* queries =
        command->add_option("--queries", queries_, "Points x,y,z to ask about (CSV)")->type_name("FILE.csv");
    command->add_option("-o,--output", output_, "Answers: 0 lit or 1 in shadow, one a row")
        ->type_name("FILE.csv")
        ->needs(queries);
    command
        ->add_option("--engine", engine_, "golden: the model alone; rtl: the hardware, compared with golden")
        ->check(CLI::IsMember({"golden", "rtl"}))
        ->capture_default_str();
    command
        ->add_option("--report", report_,
                     "Write a report: error, memory and cycles for F = 3..8, with pictures")
        ->type_name("DIR");
    command->add_flag("--json", json_, "Print the figures as JSON");
    add_set_option(*command, set_);
    add_define_option(*command, defines_);
    command->footer(
        "Exit status 1 if a word of the hardware differs from golden.\n\nExample:\n  gnomon slb --loops "
        "l.json "
        "--queries q.csv --set plane=64 -o r.csv");
    return command;
  }

  Result<int> run(Context& context) override {
    if (Result<void> complete = check_usage(); !complete) return tl::make_unexpected(complete.error());
    const Result<SlbJob> job = slb_job(context, loops_, queries_, set_);
    if (!job) return tl::make_unexpected(job.error());
    if (engine_ == "golden") return execute(context, *job, nullptr);
    const Result<Result<int>> status =
        with_models(context, [&](sim::ModelCache& cache) { return execute(context, *job, &cache); });
    if (!status) return tl::make_unexpected(status.error());
    return *status;
  }

 private:
  Result<void> check_usage() const {
    if (queries_.empty() && report_.empty())
      return fail("slb needs --queries FILE.csv with -o FILE.csv, or --report DIR, or both");
    if (!queries_.empty() && output_.empty()) return fail("--queries needs -o FILE.csv for the answers");
    return output_.empty() ? Result<void>() : check_output(output_);
  }

  Result<int> execute(Context& context, const SlbJob& job, sim::ModelCache* cache) const {
    const slb::Runner runner = slb_runner(context, job.settings, defines_, cache);
    bool passed = true;
    if (!queries_.empty()) {
      const Result<bool> answered = answer(job, runner);
      if (!answered) return tl::make_unexpected(answered.error());
      passed = *answered;
    }
    if (!report_.empty()) {
      const Result<bool> written = write_slb_report(context, job, runner, report_, reproduction(job));
      if (!written) return tl::make_unexpected(written.error());
      passed = passed && *written;
      if (!json_) fmt::print("{}\n", (report_ / "report.html").string());
    }
    return passed ? kDone : kComparisonFailed;
  }

  /// True if every comparison holds.
  Result<bool> answer(const SlbJob& job, const slb::Runner& runner) const {
    const auto start = std::chrono::steady_clock::now();
    std::vector<golden::slb::QueryPoint> points;
    points.reserve(job.receivers.size());
    for (const slb::Receiver& receiver : job.receivers)
      points.push_back(slb::to_query(receiver, job.config.slb_config()));
    const slb::EngineRun run = runner(job.config, slb::loop_stream(job.casters, points, job.config, false));
    if (Result<void> written = write_answers(run, points.size(), job.config); !written)
      return tl::make_unexpected(written.error());
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    print(job, run, seconds.count());
    return run.passed();
  }

  Result<void> write_answers(const slb::EngineRun& run, std::size_t queries,
                             const golden::HardwareConfig& config) const {
    std::vector<bool> shadows;
    shadows.reserve(queries);
    for (const golden::slb::QueryAnswer& one : slb::decode_results(run.results, queries, config).answers)
      shadows.push_back(one.shadow);
    OutputFiles files;
    Result<void> added = files.add(output_, [&](const fs::path& temporary) {
      return write_bytes(temporary, slb::answers_text(shadows));
    });
    return added ? files.commit() : added;
  }

  void print(const SlbJob& job, const slb::EngineRun& run, double seconds) const {
    const nlohmann::ordered_json figures = slb_figures(job, run, seconds);
    if (json_) {
      fmt::print("{}\n", figures.dump(2));
      return;
    }
    fmt::print("{}", slb_summary(figures));
    if (run.compare) fmt::print("{}", sim::to_text(*run.compare));
    if (!run.passed()) fmt::print("the answers written are golden's\nreproduce: {}\n", reproduction(job));
  }

  /// The command that gives the same whatever the environment says.
  std::string reproduction(const SlbJob& job) const {
    std::vector<std::string> words{"gnomon", "slb", "--loops", loops_.string(), "--engine", engine_};
    if (!queries_.empty())
      words.insert(words.end(), {"--queries", queries_.string(), "-o", output_.string()});
    if (!report_.empty()) words.insert(words.end(), {"--report", report_.string()});
    for (std::string& word : job.settings.as_flags()) words.push_back(std::move(word));
    for (const std::string& name : defines_) words.insert(words.end(), {"--define", name});
    return report::shell_line(words);
  }

  fs::path loops_, queries_, output_, report_;
  std::string engine_ = "golden";
  bool json_ = false;
  std::vector<std::string> set_, defines_;
};

}  // namespace

std::unique_ptr<Command> make_slb_command() {
  return std::make_unique<SlbCommand>();
}

}  // namespace gnomon::cli
