// SPDX-License-Identifier: Apache-2.0
// `gnomon slb --report`: the error of the buffer by width, as a directory.
#include "host/cli/slb_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "host/render/png_file.hpp"
#include "host/report/output_directory.hpp"
#include "host/slb/buffer_picture.hpp"
#include "host/slb/error_report.hpp"
#include "host/slb/report_page.hpp"

namespace gnomon::cli {
namespace {

constexpr int kWindow = 12;       // plane pixels a side of a detail
constexpr int kWindowScale = 48;  // image pixels each
constexpr int kLargestPicture = 1024;
constexpr slb::SampleOptions kSamples{1024, 1};

/// Renders pictures into the staging directory and keeps their bytes for the page.
class Pictures {
 public:
  explicit Pictures(const report::OutputDirectory& directory) : directory_(directory) {}

  Result<void> add(const std::string& file, const render::Image& image, std::string name,
                   std::string caption) {
    const std::filesystem::path path = directory_.staging() / file;
    if (Result<void> written = render::write_png(image, path); !written) return written;
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    all_.push_back({std::move(name), std::move(caption), bytes.str()});
    return {};
  }
  const std::vector<slb::ReportPicture>& all() const { return all_; }

 private:
  const report::OutputDirectory& directory_;
  std::vector<slb::ReportPicture> all_;
};

std::string lost_text(const slb::ErrorPoint& point) {
  const auto overflowing = std::count_if(point.entries.begin(), point.entries.end(),
                                         [](const golden::slb::Entry& entry) { return entry.overflow; });
  return overflowing == 0 ? "" : fmt::format(", {} pixels where something did not fit", overflowing);
}

/// The plane of the configuration that was asked for, and one detail of every width.
Result<void> draw(const std::vector<slb::ErrorPoint>& points, std::size_t shown,
                  const slb::PolygonReference& reference, Pictures& pictures) {
  const golden::slb::SlbConfig config = points[shown].config.slb_config();
  const int scale = std::clamp(kLargestPicture / config.side(), 1, 16);
  Result<void> added =
      pictures.add("plane.png",
                   slb::buffer_picture(points[shown].entries, config, slb::whole_plane(config),
                                       {scale, scale < 4 ? 4 : 3}),
                   fmt::format("The plane, F={} S={}", config.frac_bits, config.slope_bits),
                   fmt::format("{0} x {0} pixels{1}", config.side(), lost_text(points[shown])));
  const slb::Window window = slb::busiest_window(points[shown].entries, config, kWindow);
  for (const slb::ErrorPoint& point : points) {
    if (!added) return added;
    const golden::slb::SlbConfig one = point.config.slb_config();
    added =
        pictures.add(fmt::format("detail_f{}.png", one.frac_bits),
                     slb::buffer_picture(point.entries, one, window, {kWindowScale, 3}, reference.edges()),
                     fmt::format("F={} S={}", one.frac_bits, one.slope_bits),
                     fmt::format("columns {}..{}, rows {}..{}; displacement {:.3g} px", window.column,
                                 window.column + window.columns - 1, window.row, window.row + window.rows - 1,
                                 point.displacement.buffer));
  }
  return added;
}

nlohmann::ordered_json report_metrics(const SlbJob& job, const std::vector<slb::ErrorPoint>& points,
                                      const std::string& command) {
  nlohmann::ordered_json metrics = {{"schema", 1},
                                    {"loops", job.loops_file.string()},
                                    {"configuration", slb_configuration(job.config)},
                                    {"command", command}};
  std::uint64_t words = 0, differing = 0;
  bool compared = false, passed = true;
  for (const slb::ErrorPoint& point : points) {
    passed = passed && point.run.passed();
    if (!point.run.compare) continue;
    compared = true;
    words += point.run.compare->words_compared;
    differing += point.run.compare->words_differing;
  }
  metrics["passed"] = passed;
  if (compared) metrics["verdict"] = fmt::format("{} words compared, {} differ", words, differing);
  for (const slb::ErrorPoint& point : points) metrics["points"].push_back(slb::to_json(point));
  return metrics;
}

}  // namespace

Result<bool> write_slb_report(Context& context, const SlbJob& job, const slb::Runner& runner,
                              const std::filesystem::path& directory, const std::string& command) {
  Result<report::OutputDirectory> output = report::OutputDirectory::create(directory);
  if (!output) return tl::make_unexpected(output.error());
  std::vector<slb::ErrorPoint> points;
  std::size_t shown = 0;
  for (const golden::HardwareConfig& config : slb::report_configurations(job.config)) {
    context.interruption.check();
    Result<slb::ErrorPoint> point = slb::measure_error(job.scene, config, kSamples, runner);
    if (!point) return fail(fmt::format("{}: error: {}", job.loops_file.string(), point.error().message));
    if (config.frac_bits <= job.config.frac_bits) shown = points.size();
    points.push_back(std::move(*point));
  }
  Pictures pictures(*output);
  const slb::PolygonReference reference(job.scene, job.config.slb_config().side());
  Result<void> done = draw(points, shown, reference, pictures);
  const nlohmann::ordered_json metrics = report_metrics(job, points, command);
  if (done) done = output->write("report.html", slb::report_page(metrics, pictures.all()));
  if (done) done = output->write("metrics.json", metrics.dump(2) + "\n");
  if (done) done = output->commit("metrics.json");
  if (!done) return tl::make_unexpected(done.error());
  return metrics.at("passed").get<bool>();
}

}  // namespace gnomon::cli
