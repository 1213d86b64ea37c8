// SPDX-License-Identifier: Apache-2.0
// Each scene is one run of the main job, into a directory that nobody sees.
#include "host/cli/baseline_check.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "host/cli/output_files.hpp"
#include "host/cli/progress.hpp"
#include "host/cli/run_settings.hpp"
#include "host/cli/scene_input.hpp"
#include "host/pipeline/run.hpp"
#include "host/regression/result_hashes.hpp"
#include "host/scene/scene_file.hpp"
#include "host/sweep/key.hpp"
#include "sim/content_hash.hpp"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;
using regression::Baseline;
using regression::SceneFigures;

class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (fs::temp_directory_path() / "gnomon-baseline-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + " cannot be made");
    path_ = name;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

struct Measured {
  SceneFigures figures;
  report::CompareRecord compare;
};

class Check {
 public:
  Check(Context& context, const BaselineOptions& options) : context_(context), options_(options) {}

  Result<std::vector<BaselineVerdict>> run() {
    if (auto ready = prepare(); !ready) return tl::make_unexpected(ready.error());
    std::vector<BaselineVerdict> verdicts;
    for (const fs::path& scene : scenes_) {
      const auto start = std::chrono::steady_clock::now();
      Result<Measured> measured = measure(scene);
      if (!measured) return tl::make_unexpected(measured.error());
      BaselineVerdict verdict = judge(*measured);
      verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (!options_.json) print(verdict);
      verdicts.push_back(std::move(verdict));
    }
    if (options_.update) {
      if (auto written = write(verdicts); !written) return tl::make_unexpected(written.error());
    }
    return verdicts;
  }

 private:
  /// Everything that can be refused before minutes are spent.
  Result<void> prepare() {
    if (!options_.update || (fs::exists(options_.file) && options_.scenes.empty())) {
      Result<Baseline> read = regression::read_baseline(options_.file);
      if (!read) return tl::make_unexpected(read.error());
      known_ = std::move(*read);
    }
    set_ = options_.set.empty() ? known_.settings : options_.set;
    scenes_ = options_.scenes;
    if (scenes_.empty()) {
      for (const SceneFigures& scene : known_.scenes)
        scenes_.push_back(options_.file.parent_path() / scene.scene);
    }
    if (scenes_.empty()) return refuse("holds no scene, and none is given");
    for (const fs::path& scene : scenes_) {
      if (options_.update) continue;
      const SceneFigures* known = known_.find(name_of(scene));
      if (known == nullptr) return refuse(fmt::format("does not hold {}", name_of(scene)));
      const Result<LoadedScene> input = load_input(context_, scene, set_);
      if (!input) return tl::make_unexpected(input.error());
      const Result<std::string> configuration = configuration_of(scene, input->settings);
      if (!configuration) return tl::make_unexpected(configuration.error());
      if (*configuration != known->configuration)
        return refuse(
            fmt::format("{} was measured with configuration {}, this is {} (--set or the scene's "
                        "files differ); --update measures it anew",
                        known->scene, known->configuration, *configuration));
    }
    return options_.update ? check_output(options_.file) : Result<void>{};
  }

  tl::unexpected<Error> refuse(const std::string& why) const {
    return fail(fmt::format("{}: error: {}", options_.file.string(), why));
  }

  std::string name_of(const fs::path& scene) const {
    const fs::path base = fs::absolute(options_.file).parent_path();
    return fs::absolute(scene)
        .lexically_normal()
        .lexically_proximate(base.lexically_normal())
        .generic_string();
  }

  /// Everything but the program and its defaults that the figures follow from.
  Result<std::string> configuration_of(const fs::path& scene, const config::Settings& settings) const try {
    std::vector<fs::path> files{scene};
    if (scene::is_scene_file(scene)) {
      const Result<scene::SceneFile> file = scene::read_scene_file(scene);
      if (!file) return tl::make_unexpected(file.error());
      for (const scene::SceneFile::Model& model : file->models) files.push_back(model.path);
    }
    std::vector<std::string> flags = settings.as_flags();
    std::ranges::sort(flags);
    std::string text = sweep::scene_hash(files);
    for (const std::string& flag : flags) {
      if (flag != "--set" && !flag.starts_with("threads=")) text += "\n" + flag;
    }
    return sim::content_hash(text);
  } catch (const std::runtime_error& problem) {
    return fail(problem.what());
  }

  Result<Measured> measure(const fs::path& scene) {
    Result<LoadedScene> input = load_input(context_, scene, set_);
    if (!input) return tl::make_unexpected(input.error());
    Result<std::string> configuration = configuration_of(scene, input->settings);
    if (!configuration) return tl::make_unexpected(configuration.error());
    const TemporaryDirectory directory;
    regression::ResultHashes hashes;
    ProgressLine line(context_.show_progress);
    const Result<pipeline::RunOutcome> outcome =
        pipeline::run(request(std::move(*input), scene, directory.path() / "run", hashes, line));
    line.clear();
    if (!outcome) return tl::make_unexpected(outcome.error());
    return Measured{{name_of(scene), std::move(*configuration),
                     regression::figures_of(outcome->metrics, hashes.hashes())},
                    outcome->compare};
  }

  pipeline::RunRequest request(LoadedScene input, const fs::path& scene, const fs::path& output,
                               regression::ResultHashes& hashes, ProgressLine& line) const {
    pipeline::RunRequest request;
    request.output = output;
    request.settings = run_settings(input.settings);
    request.engine = pipeline::EngineKind::Rtl;
    request.seed = static_cast<std::uint32_t>(input.settings.integer("seed"));
    request.command_line = {"gnomon", "verify", scene.string()};
    for (std::string& word : input.settings.as_flags()) request.command_line.push_back(std::move(word));
    request.progress = [&line](std::string_view stage, double done) { line.update(stage, done); };
    request.abort = &context_.interruption.flag();
    request.scene = std::move(input.scene);
    request.make_golden = hashes.factory();
    if (!options_.defines.empty()) {
      request.make_rtl = [this](const golden::HardwareConfig& config, sim::RtlOptions options) {
        options.defines = options_.defines;
        return sim::make_rtl_engine(config, options);
      };
    }
    return request;
  }

  BaselineVerdict judge(const Measured& measured) {
    BaselineVerdict verdict;
    verdict.scene = measured.figures.scene;
    verdict.words = measured.compare.words;
    if (measured.compare.failed())
      verdict.failure = measured.compare.text + report::verdict(measured.compare);
    if (options_.update) {
      verdict.comparison.compared = measured.figures.figures.size();
      fresh_.put(measured.figures);
    } else {
      verdict.comparison = regression::compare(known_.find(verdict.scene)->figures, measured.figures.figures);
    }
    return verdict;
  }

  void print(const BaselineVerdict& verdict) const {
    fmt::print("{}: {}{} figures {}\n", verdict.scene, verdict.failure.empty() ? "" : verdict.failure + "; ",
               verdict.comparison.compared,
               options_.update ? "taken"
                               : fmt::format("compared, {} differ", verdict.comparison.differences.size()));
    for (const regression::Difference& difference : verdict.comparison.differences)
      fmt::print("{}: {}\n", verdict.scene, regression::to_text(difference));
  }

  Result<void> write(const std::vector<BaselineVerdict>& verdicts) {
    for (const BaselineVerdict& verdict : verdicts) {
      if (!verdict.passed()) return {};
    }
    fresh_.settings = set_;
    OutputFiles files;
    Result<void> added = files.add(options_.file, [&](const fs::path& temporary) {
      return write_bytes(temporary, regression::to_text(fresh_));
    });
    return added ? files.commit() : added;
  }

  Context& context_;
  const BaselineOptions& options_;
  Baseline known_, fresh_;
  std::vector<std::string> set_;
  std::vector<fs::path> scenes_;
};

}  // namespace

Result<std::vector<BaselineVerdict>> check_baseline(Context& context, const BaselineOptions& options) {
  return Check(context, options).run();
}

nlohmann::ordered_json to_json(const std::vector<BaselineVerdict>& verdicts) {
  nlohmann::ordered_json scenes = nlohmann::ordered_json::array();
  for (const BaselineVerdict& v : verdicts) {
    nlohmann::ordered_json differences = nlohmann::ordered_json::array();
    for (const regression::Difference& d : v.comparison.differences)
      differences.push_back({{"figure", d.figure}, {"was", d.was}, {"is", d.is}});
    scenes.push_back({{"scene", v.scene},
                      {"passed", v.passed()},
                      {"words", v.words},
                      {"failure", v.failure},
                      {"figures", v.comparison.compared},
                      {"differences", differences}});
  }
  return scenes;
}

TestCase test_case(const BaselineVerdict& verdict) {
  std::string failure = verdict.failure;
  for (const regression::Difference& difference : verdict.comparison.differences) {
    if (!failure.empty()) failure += '\n';
    failure += regression::to_text(difference);
  }
  return {verdict.scene, verdict.seconds, failure};
}

}  // namespace gnomon::cli
