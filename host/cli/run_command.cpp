// SPDX-License-Identifier: Apache-2.0
// gnomon run: from a scene to shadows, a picture, figures and a report.
#include <fmt/format.h>

#include <fstream>

#include "host/cli/command.hpp"
#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/run_settings.hpp"
#include "host/cli/scene_input.hpp"
#include "host/cli/versions.hpp"
#include "host/pipeline/run.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

/// All parameters, resolved, as the report shows them.
std::vector<report::ParameterValue> parameter_values(const config::Settings& settings) {
  std::vector<report::ParameterValue> values;
  for (const config::Parameter& parameter : config::parameters()) {
    const config::Settings::Entry& entry = settings.entry(parameter.key);
    report::ParameterValue value;
    value.key = parameter.key;
    value.value = std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, entry.value);
    value.unit = parameter.unit;
    value.origin = entry.origin;
    value.help = parameter.help;
    values.push_back(std::move(value));
  }
  return values;
}

class RunCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command =
        program.add_subcommand("run", "Shadows of a model or scene: picture, figures, report");
    command->add_option("SCENE", scene_, "OBJ control cage, or scene file (.toml, .json)")->required();
    command
        ->add_option("--engine", engine_,
                     "golden: the model alone; rtl: the hardware, checked against golden; system: the same "
                     "within a system of processor, firmware, bus and DRAM")
        ->check(CLI::IsMember({"golden", "rtl", "system"}))
        ->capture_default_str();
    command->add_option("-o,--output", output_, "Directory of the results [out/<name of the scene>]")
        ->type_name("DIR");
    command
        ->add_option("--frames", frames_,
                     "N pictures of a camera that goes once around the scene; shadows are found once")
        ->type_name("N")
        ->check(CLI::Range(1, 10000));
    command
        ->add_option("--mesh", meshes_,
                     "Write the surfaces as mesh.obj, or with their shadows as mesh.ply; repeatable")
        ->type_name("obj|ply")
        ->check(CLI::IsMember({"obj", "ply"}))
        ->allow_extra_args(false);
    command
        ->add_option("--term-after-cycles", max_cycles_,
                     "End the simulation after so many cycles; the report says how far it came")
        ->type_name("N")
        ->check(CLI::PositiveNumber);
    command->add_option("--trace", trace_, "Waveform of the simulation, from --trace-from to --trace-to")
        ->type_name("FILE.fst");
    command->add_option("--trace-from", trace_from_, "First cycle of the waveform")
        ->type_name("C")
        ->needs("--trace");
    command->add_option("--trace-to", trace_to_, "Last cycle of the waveform")
        ->type_name("C")
        ->needs("--trace");
    command
        ->add_option("--log-transactions", event_log_,
                     "What happens on the bus, interrupts and descriptors as lines of JSON; engine system")
        ->type_name("FILE.jsonl");
    command->add_flag("--json", json_, "Print the figures (what metrics.json holds) as JSON");
    add_set_option(*command, set_);
    command->footer("Example:\n  gnomon run cup.obj --set res=512 -o out/cup");
    return command;
  }

  Result<int> run(Context& context) override {
    Result<LoadedScene> input = load_input(context, scene_, set_);
    if (!input) return tl::make_unexpected(input.error());
    if (Result<void> sound = check(); !sound) return tl::make_unexpected(sound.error());
    OutputFiles files;
    const Result<pipeline::RunOutcome> outcome = run_scene(context, std::move(*input), files);
    if (!outcome) return tl::make_unexpected(outcome.error());
    if (Result<void> written = files.commit(); !written) return tl::make_unexpected(written.error());
    if (json_) {
      fmt::print("{}\n", outcome->metrics.dump(2));
    } else {
      fmt::print("{}{}\n{}\n", outcome->compare.text, report::verdict(outcome->compare),
                 (outcome->output / "report.html").string());
    }
    if (outcome->interrupted) fmt::print(stderr, "gnomon: interrupted, the comparison is partial\n");
    return outcome->interrupted ? kInterrupted : outcome->exit_status();
  }

 private:
  Result<void> check() const {
    if (engine_ == "golden" && (!trace_.empty() || max_cycles_ != UINT64_MAX))
      return fail("--trace and --term-after-cycles need an engine that has cycles: rtl or system");
    if (engine_ != "system" && !event_log_.empty()) return fail("--log-transactions needs --engine system");
    if (!trace_.empty() && trace_.extension() != ".fst")
      return fail(fmt::format("--trace {}: expected a name that ends in .fst", trace_.string()));
    return {};
  }

  /// The run, with what is written beside its results.
  Result<pipeline::RunOutcome> run_scene(Context& context, LoadedScene input, OutputFiles& files) const {
    ProgressLine line(context.show_progress);
    pipeline::RunRequest wanted = request(context, std::move(input), line);
    wanted.max_cycles = max_cycles_;
    std::ofstream log;
    if (!event_log_.empty()) {
      const auto open = [&](const fs::path& temporary) -> Result<void> {
        log.open(temporary);
        if (!log) return fail("cannot be opened");
        return {};
      };
      if (Result<void> added = files.add(event_log_, open); !added) return tl::make_unexpected(added.error());
      wanted.on_event = [&log](const std::string& event) { log << event << '\n'; };
    }
    if (!trace_.empty()) {
      const auto name = [&](const fs::path& temporary) -> Result<void> {
        wanted.trace = sim::TraceWindow{trace_from_, trace_to_, temporary};
        return {};
      };
      if (Result<void> added = files.add(trace_, name); !added) return tl::make_unexpected(added.error());
    }
    Result<pipeline::RunOutcome> outcome = pipeline::run(wanted);
    line.clear();
    return outcome;
  }

  pipeline::RunRequest request(Context& context, LoadedScene input, ProgressLine& line) const {
    pipeline::RunRequest request;
    request.output = output_.empty() ? fs::path("out") / fs::path(scene_).stem() : output_;
    request.settings = run_settings(input.settings);
    request.engine = *pipeline::engine_of(engine_);
    request.seed = static_cast<std::uint32_t>(input.settings.integer("seed"));
    request.command_line = reproduction(input.settings, request.output);
    request.frames = frames_;
    for (const std::string& mesh : meshes_)
      request.meshes.push_back(mesh == "obj" ? mesh::MeshFormat::Obj : mesh::MeshFormat::Ply);
    request.parameters = parameter_values(input.settings);
    request.earlier_stages = {{"load", input.seconds, input.user_seconds}};
    request.versions = versions();
    request.progress = [&line](std::string_view stage, double done) { line.update(stage, done); };
    request.abort = &context.interruption.flag();
    request.scene = std::move(input.scene);
    return request;
  }

  /// The command that gives the same run whatever the environment says.
  std::vector<std::string> reproduction(const config::Settings& settings, const fs::path& output) const {
    std::vector<std::string> words{"gnomon", "run", scene_.string(), "--engine", engine_};
    for (std::string& word : settings.as_flags()) words.push_back(std::move(word));
    if (frames_ > 0) words.insert(words.end(), {"--frames", std::to_string(frames_)});
    for (const std::string& mesh : meshes_) words.insert(words.end(), {"--mesh", mesh});
    words.insert(words.end(), {"-o", output.string()});
    return words;
  }

  fs::path scene_, output_;
  fs::path trace_, event_log_;
  std::uint64_t max_cycles_ = UINT64_MAX, trace_from_ = 0, trace_to_ = UINT64_MAX;
  std::string engine_ = "rtl";
  std::uint32_t frames_ = 0;
  std::vector<std::string> meshes_;
  bool json_ = false;
  std::vector<std::string> set_;
};

}  // namespace

std::unique_ptr<Command> make_run_command() {
  return std::make_unique<RunCommand>();
}

}  // namespace gnomon::cli
