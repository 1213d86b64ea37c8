// SPDX-License-Identifier: Apache-2.0
// gnomon run: from a scene to shadows, a picture, figures and a report.
#include <fmt/format.h>

#include "host/cli/command.hpp"
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
                     "golden: the model alone; rtl: the hardware, checked against golden")
        ->check(CLI::IsMember({"golden", "rtl"}))
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
    command->add_flag("--json", json_, "Print the figures (what metrics.json holds) as JSON");
    add_set_option(*command, set_);
    command->footer("Example:\n  gnomon run cup.obj --set res=512 -o out/cup");
    return command;
  }

  Result<int> run(Context& context) override {
    Result<LoadedScene> input = load_input(context, scene_, set_);
    if (!input) return tl::make_unexpected(input.error());
    ProgressLine line(context.show_progress);
    const Result<pipeline::RunOutcome> outcome = pipeline::run(request(context, std::move(*input), line));
    line.clear();
    if (!outcome) return tl::make_unexpected(outcome.error());
    if (json_) {
      fmt::print("{}\n", outcome->metrics.dump(2));
    } else {
      fmt::print("{}{}\n{}\n", outcome->compare.text, report::verdict(outcome->compare),
                 (outcome->output / "report.html").string());
    }
    return outcome->exit_status();
  }

 private:
  pipeline::RunRequest request(Context& context, LoadedScene input, ProgressLine& line) const {
    pipeline::RunRequest request;
    request.output = output_.empty() ? fs::path("out") / fs::path(scene_).stem() : output_;
    request.settings = run_settings(input.settings);
    request.engine = engine_ == "golden" ? pipeline::EngineKind::Golden : pipeline::EngineKind::Rtl;
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
