// SPDX-License-Identifier: Apache-2.0
// A cube over a ground, the directories that its runs write to, and a stand-in for the hardware.
#include "tests/host/pipeline/small_scene.hpp"

#include <unistd.h>

#include <fstream>
#include <gnomon/golden/golden_engine.hpp>
#include <iterator>
#include <stdexcept>

namespace gnomon::pipeline {
namespace {

constexpr const char* kCube = R"(o cube
v -1 -1 -1
v 1 -1 -1
v -1 1 -1
v 1 1 -1
v -1 -1 1
v 1 -1 1
v -1 1 1
v 1 1 1
v 9 9 9
f 1 5 7 3
f 2 4 8 6
f 1 2 6 5
f 3 7 8 4
f 1 3 4 2
f 5 6 8 7
)";

/// Golden behind the rtl engine's interface; a cycle a word.
class StandIn final : public sim::RtlEngine {
 public:
  explicit StandIn(std::unique_ptr<golden::Engine> engine) : engine_(std::move(engine)) {}

  std::string_view name() const override { return "stand-in"; }
  const golden::HardwareConfig& config() const override { return engine_->config(); }
  void submit(std::span<const golden::Word> words) override {
    cycles_ += words.size();
    engine_->submit(words);
  }
  void drain(const golden::ResultSink& sink) override { engine_->drain(sink); }
  golden::Counters counters() const override {
    golden::Counters counters = engine_->counters();
    counters.cycles["cycles.PROJECT.BUSY"] = counters.events["VOXELS_PROJECTED"];
    counters.cycles["cycles.RESOLVE.BUSY"] = counters.events["VOXELS_RESOLVED"];
    counters.cycles["cycles.RESOLVE.HAZARD"] = 7;
    return counters;
  }
  void reset() override { engine_->reset(); }
  std::vector<std::uint32_t> read_plane() override { return engine_->read_plane(); }

  void poll(const TimedSink&) override {}
  void drain_timed(const TimedSink& sink) override {
    engine_->drain([&](std::span<const golden::Word> words) {
      sink(words, std::vector<std::uint64_t>(words.size(), cycles_));
    });
  }
  std::uint64_t cycle() const override { return cycles_; }
  std::uint64_t sticky() const override { return 0; }
  void write_coverage(const std::filesystem::path&) override {}

 private:
  std::unique_ptr<golden::Engine> engine_;
  std::uint64_t cycles_ = 0;
};

}  // namespace

scene::Scene small_scene(const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / "cube.obj";
  std::ofstream(file) << kCube;
  auto loaded = scene::load_scene(file);
  std::filesystem::remove(file);
  if (!loaded) throw std::runtime_error(loaded.error().message);
  return std::move(*loaded);
}

RtlFactory stand_in(const sim::test::Alteration& alteration) {
  return [alteration](const golden::HardwareConfig& config,
                      const sim::RtlOptions&) -> std::unique_ptr<sim::RtlEngine> {
    std::unique_ptr<golden::Engine> engine = golden::make_golden_engine(config);
    if (alteration) engine = std::make_unique<sim::test::AlteredEngine>(std::move(engine), alteration);
    return std::make_unique<StandIn>(std::move(engine));
  };
}

RtlFactory hanging_stand_in() {
  return stand_in([](std::uint64_t, golden::Word) -> std::vector<golden::Word> {
    throw sim::HangError("nothing moved for 1000 cycles");
  });
}

void RunTest::SetUp() {
  std::string name = (std::filesystem::temp_directory_path() / "gnomon-run-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  root_ = name;
}

RunRequest RunTest::request() const {
  RunRequest made;
  made.scene = small_scene(root_);
  made.settings.res = 24;
  made.settings.image_width = 64;
  made.settings.image_height = 48;
  made.output = output();
  made.command_line = {"gnomon", "run", "cube.obj", "--set", "res=24"};
  made.parameters = {{"res", 24, "voxels", "command line", "side of the voxel grid"}};
  made.versions = {{"gnomon", "1.2.3"}};
  made.earlier_stages = {{"load", 0.25, 0.125}};
  made.make_rtl = stand_in();
  return made;
}

std::string RunTest::content(const char* name) const {
  std::ifstream file(output() / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace gnomon::pipeline
