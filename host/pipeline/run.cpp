// SPDX-License-Identifier: Apache-2.0
// The main job, stage by stage.
#include "host/pipeline/run.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <fstream>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream_io.hpp>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "host/metrics/shadow_map.hpp"
#include "host/pipeline/engines.hpp"
#include "host/pipeline/npy.hpp"
#include "host/pipeline/records.hpp"
#include "host/pipeline/stage_clock.hpp"
#include "host/pipeline/technique.hpp"
#include "host/render/png_file.hpp"
#include "host/report/metrics_json.hpp"
#include "host/report/numbers.hpp"
#include "host/report/output_directory.hpp"
#include "host/report/page.hpp"
#include "host/voxel/voxelizer.hpp"

namespace gnomon::pipeline {
namespace {

struct Pictures {
  render::Picture picture, reference;
  render::Image error;
  std::optional<render::Image> memory;
};

/// One run. Each member function is a stage, or a few that belong together; `clock_` times them.
class Job {
 public:
  explicit Job(const RunRequest& request)
      : request_(request), clock_(request.earlier_stages), record_(request_record(request)) {}

  Result<RunOutcome> run();

 private:
  Result<void> build_surfaces();
  Result<void> voxelize();
  Result<void> plan();
  void take_truth();
  Result<void> write_stream();
  void run_golden();
  Result<std::unique_ptr<sim::RtlEngine>> make_rtl(const sim::RtlOptions& options) const;
  Result<void> run_rtl();
  Result<void> decode();
  report::ShadowMapRecord measure_shadow_map(const LightPlane& plane) const;
  void measure_errors();
  void finish_record();
  render::Camera camera() const;  ///< grid coordinates
  render::PictureOptions picture_options(std::string_view stage) const;
  std::vector<Receiver> receivers() const;
  metrics::SampleAnswers sample_answers() const;
  Pictures draw();
  Result<void> write(const report::OutputDirectory& output, const nlohmann::ordered_json& metrics,
                     const Pictures& pictures) const;

  bool aborted() const { return request_.abort != nullptr && request_.abort->load(); }
  /// To be called from within stages as often as one likes.
  void progress(std::string_view stage, double done) const {
    if (aborted()) throw metrics::Cancelled();
    if (request_.progress) request_.progress(stage, done);
  }
  std::function<void(double)> progress_of(std::string_view stage) const {
    return [this, stage](double done) { progress(stage, done); };
  }
  /// The stage's result, timed, its name shown from the start.
  template <class Work>
  auto stage(std::string_view name, Work&& work) {
    progress(name, 0);
    return clock_.run(std::string(name), std::forward<Work>(work));
  }

  const RunRequest& request_;
  StageClock clock_;
  report::RunRecord record_;

  std::vector<surface::LimitSurface> surfaces_;
  std::vector<bool> two_sided_;
  voxel::Grid grid_;
  voxel::VoxelSet voxels_;
  Vec3 light_;  ///< the way it travels, grid coordinates
  std::unique_ptr<Technique> technique_;
  std::optional<metrics::ExactReference> exact_;
  metrics::ShadowTruth truth_;
  std::optional<render::PictureScene> picture_scene_;
  render::VisiblePoints visible_;  ///< where the camera looks, if the technique answers at points
  std::vector<golden::Word> stream_;
  EngineAnswers golden_;
  Answers answers_;
};

Result<void> Job::build_surfaces() {
  auto grid = scene::fit_grid(request_.scene, request_.settings.res, request_.settings.adjacency);
  if (!grid) return fail(grid.error().message);
  grid_ = *grid;
  for (const scene::Object& object : request_.scene.objects) {
    auto surface = surface::LimitSurface::build(object.mesh, scene::to_grid(object, grid_));
    if (!surface) return fail(surface.error().message);
    surfaces_.push_back(std::move(*surface));
    two_sided_.push_back(object.two_sided);
  }
  scene::to_grid(grid_).multDirMatrix(std::get<DirectionalLight>(request_.scene.lights.front()).direction,
                                      light_);
  return {};
}

Result<void> Job::voxelize() {
  voxel::VoxelizerOptions options;
  options.subpatches = true;
  options.threads = request_.settings.threads;
  options.progress = progress_of("voxelize");
  auto voxels = voxel::voxelize(surfaces_, grid_, options);
  if (!voxels) return fail(voxels.error().message);
  voxels_ = std::move(*voxels);
  return {};
}

Result<void> Job::plan() {
  auto made = make_technique(request_.settings, {surfaces_, two_sided_, voxels_, light_});
  if (!made) return fail(made.error().message);
  technique_ = std::move(*made);
  return {};
}

void Job::take_truth() {
  truth_ = stage(report::kExactStage, [&] {
    exact_.emplace(surfaces_, two_sided_, metrics::DirectionalLight{light_});
    metrics::TruthOptions options;
    options.progress = progress_of(report::kExactStage);
    options.cancelled = [this] { return aborted(); };
    return metrics::shadow_truth(*exact_, surfaces_, voxels_, options);
  });
}

/// Samples, samples along the border, points of the picture: in this order.
std::vector<Receiver> Job::receivers() const {
  std::vector<Receiver> all;
  all.reserve(truth_.samples.size() + truth_.border_samples.size() + visible_.points.size());
  for (const auto* samples : {&truth_.samples, &truth_.border_samples})
    for (const metrics::SurfaceSample& s : *samples) all.push_back({s.x, s.y, s.z, s.facing});
  all.insert(all.end(), visible_.points.begin(), visible_.points.end());
  return all;
}

Result<void> Job::write_stream() {
  std::vector<Receiver> points;
  if (technique_->answers_points()) {
    visible_ = stage("visible points", [&] {
      return picture_scene_->visible_points(camera(), *exact_, picture_options("visible points"));
    });
    points = receivers();
  }
  return stage("stream", [&]() -> Result<void> {
    auto stream = technique_->stream(points);
    if (!stream) return fail(stream.error().message);
    stream_ = std::move(*stream);
    return {};
  });
}

void Job::run_golden() {
  const auto engine = request_.make_golden ? request_.make_golden(technique_->config())
                                           : golden::make_golden_engine(technique_->config());
  golden_ = stage(report::kGoldenStage,
                  [&] { return run_stream(*engine, stream_, progress_of(report::kGoldenStage)); });
}

/// The first run of a configuration compiles its model; without a compiler or a cache that is the user's to
/// cure.
Result<std::unique_ptr<sim::RtlEngine>> Job::make_rtl(const sim::RtlOptions& options) const try {
  return request_.make_rtl ? request_.make_rtl(technique_->config(), options)
                           : sim::make_rtl_engine(technique_->config(), options);
} catch (const std::runtime_error& error) {
  return fail(error.what());
}

Result<void> Job::run_rtl() {
  sim::RtlOptions options;
  options.seed = request_.seed;
  options.abort = request_.abort;
  options.progress = [this](const sim::Progress& p) {
    progress(report::kRtlStage, static_cast<double>(p.words) / static_cast<double>(stream_.size()));
  };
  const auto engine = stage("rtl model", [&] { return make_rtl(options); });
  if (!engine) return fail(engine.error().message);
  RtlAnswers answers = stage(report::kRtlStage, [&] {
    return run_compared(**engine, stream_, golden_, request_.seed, report::shell_line(request_.command_line));
  });
  record_.compare = std::move(answers.compare);
  record_.cycles = std::move(answers.cycles);
  return {};
}

Result<void> Job::decode() {
  auto answers = technique_->decode(golden_.results);
  if (!answers) return fail(answers.error().message);
  answers_ = std::move(*answers);
  return {};
}

metrics::SampleAnswers Job::sample_answers() const {
  if (!technique_->answers_points()) return metrics::sample_answers(truth_, answers_.voxels);
  const auto samples = answers_.points.begin();
  const auto border = samples + static_cast<std::ptrdiff_t>(truth_.samples.size());
  return {{samples, border}, {border, border + static_cast<std::ptrdiff_t>(truth_.border_samples.size())}};
}

report::ShadowMapRecord Job::measure_shadow_map(const LightPlane& plane) const {
  const metrics::ShadowMap map(*exact_, plane);
  return shadow_map_record(truth_, voxels_, map.states(voxels_, two_sided_), map.answers(truth_), plane,
                           technique_->config().depth_bits, {ground_of(request_.scene), technique_->pitch()});
}

void Job::measure_errors() {
  const auto in_double = stage(report::kDoubleStage, [&] { return technique_->in_double(); });
  const std::vector<LightPlane> maps = technique_->shadow_maps();
  std::vector<report::ShadowMapRecord> map_records;
  if (!maps.empty()) {
    stage(report::kShadowMapStage, [&] {
      for (const LightPlane& map : maps) map_records.push_back(measure_shadow_map(map));
    });
  }
  stage("errors", [&] {
    record_.errors = errors_record(truth_, voxels_, answers_.voxels, sample_answers(), in_double,
                                   {ground_of(request_.scene), technique_->pitch()});
    record_.errors.shadow_maps = std::move(map_records);
    record_.exact = exact_record(*exact_, truth_);
  });
}

render::Camera Job::camera() const {
  const Mat4 to_grid = scene::to_grid(grid_);
  const scene::Camera& from = request_.scene.camera;
  render::Camera camera{from.eye * to_grid, from.target * to_grid, {}, from.fov};
  to_grid.multDirMatrix(from.up, camera.up);
  return camera;
}

render::PictureOptions Job::picture_options(std::string_view stage) const {
  render::PictureOptions options;
  options.width = request_.settings.image_width;
  options.height = request_.settings.image_height;
  options.cancelled = [this] { return aborted(); };
  options.progress = progress_of(stage);
  return options;
}

Pictures Job::draw() {
  const auto objects = static_cast<std::uint32_t>(surfaces_.size());
  const std::vector<render::Material> materials =
      render::default_materials(objects, ground_of(request_.scene).value_or(objects));
  const Light light = DirectionalLight{light_.normalized()};
  Pictures pictures;
  pictures.picture = stage("picture", [&] {
    const render::PictureOptions options = picture_options("picture");
    const render::StateShadows states{light, answers_.voxels};
    if (!technique_->answers_points())
      return picture_scene_->render(camera(), std::span(&states, 1), materials, options);
    const std::span<const std::uint8_t> points = answers_.points;
    const render::PointShadows shadows{light, visible_, points.last(visible_.points.size())};
    return picture_scene_->render(camera(), std::span(&shadows, 1), materials, options);
  });
  pictures.reference = stage("reference picture", [&] {
    const render::ExactShadows exact{light, *exact_};
    return picture_scene_->render_reference(camera(), std::span(&exact, 1), materials,
                                            picture_options("reference picture"));
  });
  pictures.memory = stage("memory picture", [&] { return technique_->memory_picture(golden_.results); });
  pictures.error = stage("error map", [&] {
    record_.picture = picture_record(pictures.picture, pictures.reference);
    return render::error_map(pictures.picture, pictures.reference);
  });
  return pictures;
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Result<void> Job::write(const report::OutputDirectory& output, const nlohmann::ordered_json& metrics,
                        const Pictures& pictures) const {
  const auto png = [&](const char* name, const render::Image& image) -> Result<std::string> {
    if (auto written = render::write_png(image, output.staging() / name); !written)
      return fail(written.error().message);
    return content_of(output.staging() / name);
  };
  const Result<std::string> image = png("image.png", pictures.picture.image);
  const Result<std::string> reference = png("reference.png", pictures.reference.image);
  const Result<std::string> error = png("error.png", pictures.error);
  const Result<std::string> memory = pictures.memory ? png("memory.png", *pictures.memory) : std::string();
  for (const auto* file : {&image, &reference, &error, &memory}) {
    if (!*file) return fail(file->error().message);
  }
  if (const auto problem =
          golden::save_stream(output.staging() / "stream.gnomon", technique_->config(), stream_)) {
    return fail(*problem);
  }
  if (auto done = output.write("voxels.npy", voxels_npy(voxels_, answers_.voxels)); !done) return done;
  if (auto done = output.write("metrics.json", metrics.dump(2) + "\n"); !done) return done;
  return output.write("report.html", report::report_page(metrics, {*image, *reference, *error, *memory}));
}

/// What stands only after the last stage.
void Job::finish_record() {
  record_.grid = voxels_.grid;
  record_.voxel_statistics = voxels_.statistics;
  record_.voxels = voxels_.voxels.size();
  record_.voxels_in_shadow =
      static_cast<std::uint64_t>(std::ranges::count(answers_.voxels, golden::VoxelState::Shadow));
  record_.hardware = technique_->config();
  technique_->describe(golden_, record_);
  record_.command_words = stream_.size();
  record_.events = golden_.counters.events;
  record_.stages = clock_.stages();
  record_.peak_memory_bytes = peak_memory_bytes();
}

Result<RunOutcome> Job::run() {
  auto output = report::OutputDirectory::create(request_.output);
  if (!output) return fail(output.error().message);

  if (auto done = stage("surface", [&] { return build_surfaces(); }); !done)
    return fail(done.error().message);
  if (auto done = stage("voxelize", [&] { return voxelize(); }); !done) return fail(done.error().message);
  if (auto done = stage("plan", [&] { return plan(); }); !done) return fail(done.error().message);
  take_truth();
  stage("picture scene", [&] { picture_scene_.emplace(surfaces_, voxels_); });
  if (auto done = write_stream(); !done) return fail(done.error().message);
  run_golden();
  if (request_.engine == EngineKind::Rtl) {
    if (auto done = run_rtl(); !done) return fail(done.error().message);
  }
  if (auto done = stage("decode", [&] { return decode(); }); !done) return fail(done.error().message);
  measure_errors();
  const Pictures pictures = draw();

  finish_record();
  nlohmann::ordered_json metrics = report::metrics_json(record_);
  if (auto done = write(*output, metrics, pictures); !done) return fail(done.error().message);
  progress("report", 1);
  if (auto done = output->commit("metrics.json"); !done) return fail(done.error().message);
  return RunOutcome{record_.compare, std::move(metrics), request_.output};
}

/// What cannot be run, before anything is.
Result<void> check(const RunRequest& request) {
  if (request.scene.lights.size() != 1) {
    return fail(fmt::format("{}: has {} lights, expected one: a run takes a single directional light",
                            request.scene.source.string(), request.scene.lights.size()));
  }
  if (!std::holds_alternative<DirectionalLight>(request.scene.lights.front())) {
    return fail(request.scene.source.string() +
                ": its light is not directional: a run takes a single directional light");
  }
  if (request.scene.objects.empty())
    return fail(request.scene.source.string() + ": has no objects, expected at least one");
  return {};
}

}  // namespace

Result<RunOutcome> run(const RunRequest& request) {
  if (auto usable = check(request); !usable) return fail(usable.error().message);
  const unsigned threads = request.settings.threads;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()));
  try {
    return Job(request).run();
  } catch (const metrics::Cancelled&) {
    return fail("interrupted");
  } catch (const sim::Aborted&) {
    return fail("interrupted");
  }
}

}  // namespace gnomon::pipeline
