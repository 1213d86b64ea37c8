// SPDX-License-Identifier: Apache-2.0
// gnomon wave: a waveform of some cycles, or of what led to the first difference.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <gnomon/golden/golden_engine.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/shadow_jobs.hpp"
#include "host/cli/system_settings.hpp"
#include "sim/wave.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

// Around a trigger.
constexpr std::uint64_t kBefore = 50, kAfter = 300;

class WaveCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command = program.add_subcommand("wave", "Write a waveform of a window of cycles");
    command->add_option("SCENE", scene_, "OBJ control cage, or scene file")->required();
    CLI::Option* from =
        command->add_option("--from", from_, "First cycle, counted from reset")->type_name("C");
    CLI::Option* to = command->add_option("--to", to_, "Last cycle")->type_name("C");
    CLI::Option* difference = command->add_flag("--first-difference", difference_,
                                                "The cycles around the first word that differs from golden");
    CLI::Option* first =
        command->add_option("--first", first_, "The cycles from the first such command on, e.g. QUERY")
            ->type_name("COMMAND");
    CLI::Option* address =
        command
            ->add_option("--address", address_,
                         "The cycles around the hardware's first access to memory that touches this address; "
                         "engine system")
            ->type_name("A");
    const std::array triggers{difference, first, address};
    for (std::size_t i = 0; i < triggers.size(); ++i) {
      triggers.at(i)->excludes(from)->excludes(to);
      for (std::size_t j = 0; j < i; ++j) triggers.at(i)->excludes(triggers.at(j));
    }
    add_engine_option(*command, engine_);
    command->add_option("-o,--output", output_, "Waveform file")->type_name("FILE.fst")->required();
    add_set_option(*command, set_);
    add_define_option(*command, defines_);
    command->footer(
        "A scene of several lights shows the first.\n\nExample:\n  gnomon wave cup.obj --from 5000 --to 5200 "
        "-o cup.fst\n  gnomon wave cup.obj --set technique=slb --first QUERY -o query.fst");
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
      auto made = with_models(context, [&](sim::ModelCache& cache) {
        return trace(context, cache, jobs->front(), input->settings, temporary);
      });
      if (!made) return tl::make_unexpected(made.error());
      if (!*made) return tl::make_unexpected(made->error());
      wave = std::move(**made);
      return {};
    });
    if (!added) return tl::make_unexpected(added.error());
    return finish(files, wave);
  }

 private:
  Result<void> check() const {
    const bool triggered = difference_ || !first_.empty() || address_;
    if (!triggered && (!from_ || !to_))
      return fail("a window is needed: --from C --to C, --first-difference, --first COMMAND, or --address A");
    if (!triggered && *from_ > *to_) return fail(fmt::format("--from {} is after --to {}", *from_, *to_));
    if (output_.extension() != ".fst")
      return fail(fmt::format("-o {}: expected a name that ends in .fst", output_.string()));
    const bool within = engine_ == "system";
    if (address_ && !within) return fail("--address: accesses to memory need --engine system");
    if (within && (difference_ || !first_.empty()))
      return fail("--engine system shows windows of cycles and of --address");
    return check_output(output_);
  }

  /// The cycles to show. Throws as the engines.
  Result<sim::TraceWindow> window(const config::Settings& settings, const ShadowJob& job,
                                  const sim::RtlOptions& options, sim::ModelCache& cache,
                                  const fs::path& file) const {
    if (from_) return sim::TraceWindow{*from_, *to_, file};
    std::optional<std::uint64_t> cycle;
    if (address_) {
      cycle = first_access(settings, job, options, cache);
      if (!cycle)
        return fail(fmt::format("--address {:#x}: no access of the hardware touches it", *address_));
    } else if (const auto at = sim::find_command(job.stream, first_)) {
      cycle = sim::cycle_of_header(job.config, options, job.stream, *at, cache);
    } else {
      return fail(fmt::format("--first {}: the stream has no such command", first_));
    }
    return sim::TraceWindow{*cycle - std::min(*cycle, kBefore), *cycle + kAfter, file};
  }

  /// The cycle at which the hardware first touches the address, found without a waveform. The simulation has
  /// one flag that ends it, which either the access or Ctrl-C sets. Throws sim::Aborted after the latter.
  std::optional<std::uint64_t> first_access(const config::Settings& settings, const ShadowJob& job,
                                            sim::RtlOptions options, sim::ModelCache& cache) const {
    std::atomic<bool> ended = false;
    std::optional<std::uint64_t> cycle;
    const std::atomic<bool>* const interrupted = options.abort;
    options.trace_model = true;
    options.abort = &ended;
    options.progress = [&](const sim::Progress&) {
      if (interrupted->load()) ended = true;
    };
    sim::system::SystemOptions system = system_settings(settings);
    system.rtl = options;
    const auto engine = sim::system::make_system_engine(job.config, system, cache);
    engine->set_event_log([&](const std::string& line) {
      const nlohmann::json event = nlohmann::json::parse(line);
      if (ended || event.at("event") != "transaction" || event.at("initiator") != "hardware") return;
      const std::uint64_t address = std::stoull(event.at("address").get<std::string>(), nullptr, 16);
      if (*address_ < address || *address_ - address >= event.at("bytes").get<std::uint64_t>()) return;
      cycle = event.at("begin").get<std::uint64_t>();
      ended = true;
    });
    try {
      engine->submit(job.stream);
      engine->drain([](std::span<const golden::Word>) {});
    } catch (const sim::Aborted&) {
    }
    if (!cycle && interrupted->load()) throw sim::Aborted("interrupted");
    return cycle;
  }

  Result<sim::Wave> trace(Context& context, sim::ModelCache& cache, const ShadowJob& job,
                          const config::Settings& settings, const fs::path& file) const {
    const sim::RtlOptions plain = rtl_options(context, settings, defines_);
    if (!difference_) {
      const Result<sim::TraceWindow> shown = window(settings, job, plain, cache, file);
      if (!shown) return tl::make_unexpected(shown.error());
      ProgressLine line(context.show_progress);
      sim::RtlOptions options = plain;
      options.progress = [&](const sim::Progress& p) {
        line.update(engine_, static_cast<double>(p.cycles) / static_cast<double>(shown->to + 1));
      };
      const auto make = [&](const sim::RtlOptions& traced) {
        return engine_under_test(engine_, settings, job.config, traced, cache);
      };
      return sim::write_window(make, options, job.stream, *shown);
    }
    ProgressLine line(context.show_progress);
    sim::RtlOptions options = plain;
    options.progress = [&](const sim::Progress& p) {
      line.update("rtl", static_cast<double>(p.words) / static_cast<double>(job.stream.size()));
    };
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
  std::optional<std::uint64_t> from_, to_, address_;
  bool difference_ = false;
  std::string first_, engine_ = "rtl";
  std::vector<std::string> set_, defines_;
};

}  // namespace

std::unique_ptr<Command> make_wave_command() {
  return std::make_unique<WaveCommand>();
}

}  // namespace gnomon::cli
