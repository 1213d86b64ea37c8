// SPDX-License-Identifier: Apache-2.0
// gnomon wave: a waveform of some cycles, or of what led to the first difference.
#include <fmt/format.h>

#include <gnomon/golden/golden_engine.hpp>
#include <optional>

#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/shadow_jobs.hpp"
#include "sim/wave.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

class WaveCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("wave", "Write a waveform of a window of cycles");
    command->add_option("SCENE", scene_, "OBJ control cage, or scene file")->required();
    CLI::Option* from =
        command->add_option("--from", from_, "First cycle, counted from reset")->type_name("C");
    CLI::Option* to = command->add_option("--to", to_, "Last cycle")->type_name("C");
    command
        ->add_flag("--first-difference", difference_,
                   "The cycles around the first word that differs from golden")
        ->excludes(from)
        ->excludes(to);
    command->add_option("-o,--output", output_, "Waveform file")->type_name("FILE.fst")->required();
    add_set_option(*command, set_);
    add_define_option(*command, defines_);
    command->footer(
        "A scene of several lights shows the first.\n\nExample:\n  gnomon wave cup.obj --from 5000 --to 5200 "
        "-o cup.fst");
    return command;
  }

  Result<int> run(Context& context) override {
    if (Result<void> sound = check(); !sound) return tl::make_unexpected(sound.error());
    const Result<LoadedScene> input = load_input(context, scene_, set_);
    if (!input) return tl::make_unexpected(input.error());
    const Result<std::vector<ShadowJob>> jobs = shadow_jobs(context, *input);
    if (!jobs) return tl::make_unexpected(jobs.error());
    OutputFiles files;
    sim::Wave wave;
    const Result<void> added = files.add(output_, [&](const fs::path& temporary) -> Result<void> {
      Result<sim::Wave> made = with_models(context, [&](sim::ModelCache& cache) {
        return trace(context, cache, jobs->front(), input->settings, temporary);
      });
      if (!made) return tl::make_unexpected(made.error());
      wave = std::move(*made);
      return {};
    });
    if (!added) return tl::make_unexpected(added.error());
    return finish(files, wave);
  }

 private:
  Result<void> check() const {
    if (!difference_ && (!from_ || !to_))
      return fail("a window is needed: --from C --to C, or --first-difference");
    if (!difference_ && *from_ > *to_) return fail(fmt::format("--from {} is after --to {}", *from_, *to_));
    if (output_.extension() != ".fst")
      return fail(fmt::format("-o {}: expected a name that ends in .fst", output_.string()));
    return check_output(output_);
  }

  sim::Wave trace(Context& context, sim::ModelCache& cache, const ShadowJob& job,
                  const config::Settings& settings, const fs::path& file) const {
    sim::RtlOptions options = rtl_options(context, settings, defines_);
    ProgressLine line(context.show_progress);
    options.progress = [&](const sim::Progress& p) {
      const double all = difference_ ? static_cast<double>(job.stream.size()) : static_cast<double>(*to_ + 1);
      line.update("rtl", static_cast<double>(difference_ ? p.words : p.cycles) / all);
    };
    if (!difference_) return sim::write_window(job.config, options, job.stream, {*from_, *to_, file}, cache);
    const auto golden = golden::make_golden_engine(job.config);
    return sim::write_first_difference(*golden, options, job.stream, file, {}, cache);
  }

  /// Exit status 1 tells that there was a difference to show.
  Result<int> finish(OutputFiles& files, const sim::Wave& wave) const {
    if (wave.report) fmt::print("{}", sim::to_text(*wave.report));
    if (wave.report && wave.report->consistent()) {
      fmt::print("no difference, no waveform\n");
      return kDone;
    }
    if (Result<void> written = files.commit(); !written) return tl::make_unexpected(written.error());
    fmt::print("{}: cycles {} to {}\n", output_.string(), wave.window.from, wave.window.to);
    return wave.report ? kComparisonFailed : kDone;
  }

  fs::path scene_, output_;
  std::optional<std::uint64_t> from_, to_;
  bool difference_ = false;
  std::vector<std::string> set_, defines_;
};

}  // namespace

std::unique_ptr<Command> make_wave_command() {
  return std::make_unique<WaveCommand>();
}

}  // namespace gnomon::cli
