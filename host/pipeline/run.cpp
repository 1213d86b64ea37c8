// SPDX-License-Identifier: Apache-2.0
// The main job, stage by stage.
#include "host/pipeline/run.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <fstream>
#include <gnomon/golden/stream_io.hpp>
#include <iterator>
#include <thread>

#include "host/pipeline/lit_scene.hpp"
#include "host/pipeline/npy.hpp"
#include "host/pipeline/scene_meshes.hpp"
#include "host/pipeline/software_technique.hpp"
#include "host/pipeline/technique_job.hpp"
#include "host/render/png_file.hpp"
#include "host/report/metrics_json.hpp"
#include "host/report/output_directory.hpp"
#include "host/report/page.hpp"

namespace gnomon::pipeline {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The results of one technique as files of the output directory; `suffix` tells those of several apart.
class ResultFiles {
 public:
  ResultFiles(const report::OutputDirectory& output, const LitScene& scene)
      : output_(output), scene_(scene) {}

  /// The picture's own bytes.
  Result<std::string> png(const std::string& name, const render::Image& image) const {
    if (auto written = render::write_png(image, output_.staging() / name); !written)
      return fail(written.error().message);
    return content_of(output_.staging() / name);
  }

  Result<report::TechniquePictures> add(const TechniqueJob& job, const std::string& suffix) const {
    const TechniquePictures& drawn = job.pictures();
    report::TechniquePictures pictures;
    pictures.technique = job.name();
    if (auto done = add_picture("image" + suffix, drawn.picture.image, pictures.image); !done)
      return fail(done.error().message);
    if (auto done = add_picture("error" + suffix, drawn.error, pictures.error); !done)
      return fail(done.error().message);
    if (drawn.memory) {
      if (auto done = add_picture("memory" + suffix, *drawn.memory, pictures.memory); !done)
        return fail(done.error().message);
    }
    const auto stream = output_.staging() / ("stream" + suffix + ".gnomon");
    if (const auto problem = golden::save_stream(stream, job.hardware(), job.stream())) return fail(*problem);
    if (auto done = output_.write("voxels" + suffix + ".npy", voxels_npy(scene_.voxels, job.states())); !done)
      return fail(done.error().message);
    return pictures;
  }

 private:
  Result<void> add_picture(const std::string& name, const render::Image& image, std::string& bytes) const {
    Result<std::string> written = png(name + ".png", image);
    if (!written) return fail(written.error().message);
    bytes = std::move(*written);
    return {};
  }

  const report::OutputDirectory& output_;
  const LitScene& scene_;
};

Result<nlohmann::ordered_json> write(const report::OutputDirectory& output, const LitScene& scene,
                                     std::span<const std::unique_ptr<TechniqueJob>> jobs,
                                     std::span<const report::RunRecord> records) {
  const ResultFiles files(output, scene);
  report::Pictures pictures;
  Result<std::string> reference = files.png("reference.png", scene.reference.image);
  if (!reference) return fail(reference.error().message);
  pictures.reference = std::move(*reference);
  for (const auto& job : jobs) {
    auto drawn = files.add(*job, job == jobs.front() ? "" : "-" + job->name());
    if (!drawn) return fail(drawn.error().message);
    pictures.techniques.push_back(std::move(*drawn));
  }
  nlohmann::ordered_json metrics = report::metrics_json(records);
  if (auto done = output.write("metrics.json", metrics.dump(2) + "\n"); !done)
    return fail(done.error().message);
  if (auto done = output.write("report.html", report::report_page(metrics, pictures)); !done)
    return fail(done.error().message);
  return metrics;
}

Result<RunOutcome> run_all(const RunRequest& request) {
  auto output = report::OutputDirectory::create(request.output);
  if (!output) return fail(output.error().message);
  Stages stages(request, request.earlier_stages);
  LitScene scene;
  if (auto done = scene.build(request, stages); !done) return fail(done.error().message);
  std::vector<std::unique_ptr<TechniqueJob>> jobs;
  for (const std::string& name : request.settings.techniques) {
    jobs.push_back(std::make_unique<TechniqueJob>(request, scene, name));
    if (auto done = jobs.back()->plan(); !done) return fail(done.error().message);
  }
  scene.look(request, stages);
  std::vector<report::RunRecord> records;
  for (const auto& job : jobs) {
    if (auto done = job->run(); !done) return fail(done.error().message);
    job->draw();
    if (job->interrupted()) {
      records.push_back(job->record(stages.times()));
      stages.finish();
      break;
    }
    const std::string suffix = job == jobs.front() ? "" : "-" + job->name();
    if (auto done = job->draw_frames(output->staging() / ("frames" + suffix)); !done)
      return fail(done.error().message);
    records.push_back(job->record(stages.times()));
  }
  const bool interrupted = records.size() < jobs.size() || jobs.back()->interrupted();
  jobs.resize(records.size());
  if (auto done = interrupted ? Result<void>() : write_meshes(*output, request, scene, jobs, stages); !done)
    return fail(done.error().message);
  auto metrics = write(*output, scene, jobs, records);
  if (!metrics) return fail(metrics.error().message);
  stages.progress("report", 1);
  if (auto done = output->commit("metrics.json"); !done) return fail(done.error().message);
  const auto failed = std::ranges::find_if(jobs, [](const auto& job) { return job->compare().failed(); });
  return RunOutcome{(failed == jobs.end() ? jobs.front() : *failed)->compare(), std::move(*metrics),
                    request.output, interrupted};
}

/// What cannot be run, before anything is.
Result<void> check(const RunRequest& request) {
  const std::string source = request.scene.source.string();
  if (request.scene.lights.empty()) return fail(source + ": has no lights, expected at least one");
  if (request.scene.objects.empty()) return fail(source + ": has no objects, expected at least one");
  if (request.settings.techniques.empty()) return fail("technique is empty, expected at least one");
  if (request.trace && request.settings.techniques.size() > 1)
    return fail("a waveform shows one technique, several are asked for");
  for (const std::string& name : request.settings.techniques) {
    if (request.frames > 0 && request.scene.lights.size() > 1 &&
        (name.starts_with("slb") || is_software(name)))
      return fail(
          fmt::format("{}: has {} lights, expected one with technique={} and --frames: it keeps what it "
                      "knows of one light at a time",
                      source, request.scene.lights.size(), name));
  }
  return check_lights(request.scene, request.settings.techniques);
}

}  // namespace

Result<RunOutcome> run(const RunRequest& request) {
  if (auto usable = check(request); !usable) return fail(usable.error().message);
  const unsigned threads = request.settings.threads;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()));
  try {
    return run_all(request);
  } catch (const metrics::Cancelled&) {
    return fail("interrupted");
  } catch (const sim::Aborted&) {
    return fail("interrupted");
  }
}

}  // namespace gnomon::pipeline
