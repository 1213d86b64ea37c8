// SPDX-License-Identifier: Apache-2.0
// gnomon verify: the hardware against golden, word for word.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <gnomon/golden/golden_engine.hpp>
#include <iterator>
#include <nlohmann/json.hpp>

#include "host/cli/baseline_check.hpp"
#include "host/cli/junit.hpp"
#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/shadow_jobs.hpp"
#include "sim/compare.hpp"
#include "sim/wave.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

/// One technique for one light of one scene.
struct Verdict {
  std::string name;
  sim::CompareReport report;
  double seconds = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class VerifyCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("verify", "Compare the hardware with golden, word for word");
    command->add_option("SCENE", scenes_,
                        "OBJ control cages, or scene files; may be missing with --baseline");
    add_engine_option(*command, engine_);
    add_set_option(*command, set_);
    add_define_option(*command, defines_);
    CLI::Option* baseline =
        command
            ->add_option(
                "--baseline", baseline_,
                "Compare cycles, errors and hashes of results with a file, too (docs/verification.md)")
            ->type_name("FILE");
    command->add_flag("--update", update_, "Measure the baseline and write it instead")->needs(baseline);
    command
        ->add_option("--trace", trace_,
                     "Where a comparison fails, write the waveform around the first difference; engine rtl")
        ->type_name("FILE.fst");
    command
        ->add_option("--term-after-cycles", max_cycles_,
                     "End each comparison after so many cycles; what was compared till then counts")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    command->add_option("--junit", junit_, "Write the verdicts as JUnit XML, too")->type_name("FILE");
    command->add_flag("--json", json_, "Print the comparisons as JSON");
    command->footer(
        "Exit status 1 if a word differs, or a figure of the baseline, or if none was "
        "compared.\n\nExample:\n  "
        "gnomon verify cup.obj links.toml --set res=128");
    return command;
  }

  Result<int> run(Context& context) override {
    if (!junit_.empty()) {
      if (Result<void> possible = check_output(junit_); !possible)
        return tl::make_unexpected(possible.error());
    }
    if (!baseline_.empty()) return with_baseline(context);
    if (scenes_.empty()) return fail("command line: error: SCENE is required");
    if (!trace_.empty() && engine_ != "rtl") return fail("--trace needs --engine rtl");
    std::vector<Verdict> verdicts;
    for (const fs::path& scene : scenes_) {
      if (Result<void> done = verify(context, scene, verdicts); !done)
        return tl::make_unexpected(done.error());
    }
    if (context.interruption.requested() && verdicts.empty()) throw Interrupted();
    std::vector<TestCase> cases;
    cases.reserve(verdicts.size());
    for (const Verdict& v : verdicts)
      cases.push_back({v.name, v.seconds, v.report.passed() ? "" : sim::to_text(v.report)});
    if (Result<void> written = write_junit(cases); !written) return tl::make_unexpected(written.error());
    if (json_) print_json(verdicts);
    if (context.interruption.requested()) return kInterrupted;
    const bool passed =
        std::all_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.report.passed(); });
    return passed ? kDone : kComparisonFailed;
  }

 private:
  Result<int> with_baseline(Context& context) const {
    if (engine_ != "rtl")
      return fail("command line: error: --baseline holds cycles of --engine rtl, not of " + engine_);
    const Result<std::vector<BaselineVerdict>> verdicts =
        check_baseline(context, {baseline_, scenes_, set_, defines_, update_, json_});
    if (!verdicts) return tl::make_unexpected(verdicts.error());
    std::vector<TestCase> cases;
    std::ranges::transform(*verdicts, std::back_inserter(cases), test_case);
    if (Result<void> written = write_junit(cases); !written) return tl::make_unexpected(written.error());
    if (json_) fmt::print("{}\n", to_json(*verdicts).dump(2));
    return std::ranges::all_of(*verdicts, &BaselineVerdict::passed) ? kDone : kComparisonFailed;
  }

  Result<void> verify(Context& context, const fs::path& scene, std::vector<Verdict>& verdicts) const {
    const Result<LoadedScene> input = load_input(context, scene, set_);
    if (!input) return tl::make_unexpected(input.error());
    const Result<std::vector<ShadowJob>> jobs = shadow_jobs(context, *input);
    if (!jobs) return tl::make_unexpected(jobs.error());
    for (std::size_t i = 0; i < jobs->size(); ++i) {
      Result<Verdict> verdict = with_models(context, [&](sim::ModelCache& cache) {
        return compare(context, cache, (*jobs)[i], input->settings);
      });
      if (!verdict) return tl::make_unexpected(verdict.error());
      const std::string& job = (*jobs)[i].name;
      verdict->name = job.empty() ? scene.string() : scene.string() + ", " + job;
      if (!json_) print_text(*verdict, scene, input->settings);
      verdicts.push_back(std::move(*verdict));
      if (context.interruption.requested()) return {};
      if (!verdicts.back().report.passed() && !trace_.empty()) {
        if (auto traced = trace(context, (*jobs)[i], input->settings); !traced) return traced;
      }
    }
    return {};
  }

  Verdict compare(Context& context, sim::ModelCache& cache, const ShadowJob& job,
                  const config::Settings& settings) const {
    sim::RtlOptions options = rtl_options(context, settings, defines_);
    options.max_cycles = max_cycles_;
    ProgressLine line(context.show_progress);
    options.progress = [&](const sim::Progress& p) {
      line.update(engine_, static_cast<double>(p.words) / static_cast<double>(job.stream.size()));
    };
    const auto golden = golden::make_golden_engine(job.config);
    const auto rtl = engine_under_test(engine_, settings, job.config, options, cache);
    const auto start = std::chrono::steady_clock::now();
    sim::CompareOptions what;
    what.plane = true;
    what.keep_partial = true;
    Verdict verdict;
    verdict.report = sim::compare(*golden, *rtl, job.stream, what, options.seed);
    verdict.seconds = seconds_since(start);
    return verdict;
  }

  /// The first difference once more, recorded; later ones replace earlier ones.
  Result<void> trace(Context& context, const ShadowJob& job, const config::Settings& settings) const {
    OutputFiles files;
    const Result<void> added = files.add(trace_, [&](const fs::path& temporary) -> Result<void> {
      const auto made = with_models(context, [&](sim::ModelCache& cache) {
        const auto golden = golden::make_golden_engine(job.config);
        return sim::write_first_difference(*golden, rtl_options(context, settings, defines_), job.stream,
                                           temporary, {}, cache);
      });
      if (!made) return tl::make_unexpected(made.error());
      if (!json_) fmt::print("{}: cycles {} to {}\n", trace_.string(), made->window.from, made->window.to);
      return {};
    });
    return added ? files.commit() : added;
  }

  void print_text(const Verdict& verdict, const fs::path& scene, const config::Settings& settings) const {
    std::string text = sim::to_text(verdict.report);
    text.pop_back();
    fmt::print("{}: {}", verdict.name, verdict.report.passed() ? "" : "\n");
    const double rate = static_cast<double>(verdict.report.cycles) / verdict.seconds / 1e6;
    fmt::print("{} ({} cycles, {:.2f} Mcycles/s)\n", text, verdict.report.cycles, rate);
    if (verdict.report.passed()) return;
    fmt::print("reproduce: gnomon verify {} {}{}{}\n", scene.string(),
               engine_ == "rtl" ? "" : "--engine " + engine_ + " ", fmt::join(settings.as_flags(), " "),
               define_flags());
  }

  std::string define_flags() const {
    std::string text;
    for (const std::string& name : defines_) text += " --define " + name;
    return text;
  }

  Result<void> write_junit(const std::vector<TestCase>& cases) const {
    if (junit_.empty()) return {};
    OutputFiles files;
    Result<void> added = files.add(junit_, [&](const fs::path& temporary) {
      return write_bytes(temporary, junit_xml("gnomon verify", cases));
    });
    return added ? files.commit() : added;
  }

  static void print_json(const std::vector<Verdict>& verdicts) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Verdict& v : verdicts) {
      list.push_back({{"scene", v.name}, {"seconds", v.seconds}, {"compare", sim::to_json(v.report)}});
    }
    fmt::print("{}\n", list.dump(2));
  }

  std::vector<fs::path> scenes_;
  std::string engine_ = "rtl";
  std::vector<std::string> set_, defines_;
  fs::path junit_, baseline_, trace_;
  bool update_ = false, json_ = false;
  std::uint64_t max_cycles_ = UINT64_MAX;
};

}  // namespace

std::unique_ptr<Command> make_verify_command() {
  return std::make_unique<VerifyCommand>();
}

}  // namespace gnomon::cli
