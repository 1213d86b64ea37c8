// SPDX-License-Identifier: Apache-2.0
// Runs the model in slices, so that progress, interruption and hangs are looked at without slowing the clock
// loop.
#include "sim/rtl_engine.hpp"

#include <algorithm>
#include <utility>

#include "sim/counter_names.hpp"
#include "sim/counters.hpp"
#include "sim/plane_reading.hpp"

namespace gnomon::sim {

namespace {

constexpr std::uint64_t kResultRoom = 1u << 16;

GnomonModelGate gate_of(const PortStall& stall) {
  return {static_cast<std::uint32_t>(stall.open_per_256), static_cast<std::uint32_t>(stall.block_log2)};
}

GnomonModelStalls stalls_of(const StallProfile& profile) {
  return {gate_of(profile.command), gate_of(profile.result), profile.seed};
}

/// Longest time without a word moving in sound hardware: the clear of the larger plane, 16 entries a cycle,
/// a fill of all its rows with lines everywhere, quads as large as the plane, a list of all nodes, or the
/// clear of the frame buffer, 16 bricks a cycle; a port that is rarely open.
std::uint64_t default_hang_cycles(const golden::HardwareConfig& config, const StallProfile& stalls) {
  const int plane_log2 =
      config.en_slb ? std::max(config.plane_log2, config.slb_plane_log2) : config.plane_log2;
  const auto side = std::uint64_t{1} << plane_log2;
  const std::uint64_t longest_block = std::uint64_t{1}
                                      << std::max(stalls.command.block_log2, stalls.result.block_log2);
  const std::uint64_t fill = config.en_slb ? std::uint64_t{4} << (2 * config.slb_plane_log2) : 0;
  const std::uint64_t lists =
      config.en_vpu_topology ? 32 * side * side + (std::uint64_t{32} << config.nodes_log2) : 0;
  const int lines_log2 = 3 * config.voxel_bits - 10 + config.frame_layers_log2;
  const std::uint64_t frame = config.en_frame_buffer ? std::uint64_t{2} << lines_log2 : 0;
  return 20'000 + side * side / 8 + fill + lists + frame + 2'000 * longest_block;
}

bool ended(int stop) {
  return stop == GNOMON_STOP_TAKEN || stop == GNOMON_STOP_IDLE;
}

class RtlEngineImpl final : public RtlEngine {
 public:
  RtlEngineImpl(const golden::HardwareConfig& config, RtlOptions options,
                std::shared_ptr<const ModelLibrary> library)
      : config_(config),
        options_(std::move(options)),
        library_(std::move(library)),
        api_(library_->api()),
        model_(api_.create(options_.seed), api_.destroy) {
    if (options_.hang_cycles == 0) options_.hang_cycles = default_hang_cycles(config_, options_.stalls);
    const GnomonModelStalls stalls = stalls_of(options_.stalls);
    api_.set_stalls(model_.get(), &stalls);
    if (options_.trace) open_trace(*options_.trace);
  }

  std::string_view name() const override { return "rtl"; }
  const golden::HardwareConfig& config() const override { return config_; }

  void submit(std::span<const Word> words) override {
    GnomonModelRun run = new_run(words);
    run_to_end(run);
    words_taken_ += words.size();
    report(0);
  }

  void drain(const golden::ResultSink& sink) override {
    drain_timed([&](std::span<const Word> words, std::span<const std::uint64_t>) { sink(words); });
  }

  void drain_timed(const TimedSink& sink) override {
    GnomonModelRun run = new_run({});
    run.until_idle = 1;
    run_to_end(run);
    report(0);
    poll(sink);
  }

  void poll(const TimedSink& sink) override {
    const std::vector<Word> results = std::exchange(results_, {});
    const std::vector<std::uint64_t> cycles = std::exchange(result_cycles_, {});
    if (!results.empty()) sink(results, cycles);
  }

  golden::Counters counters() const override {
    return read_counters(config_, [this](std::uint32_t index) { return counter(index); });
  }

  void reset() override {
    api_.reset(model_.get());
    results_.clear();
    result_cycles_.clear();
    words_taken_ = results_given_ = quiet_since_ = 0;
  }

  std::vector<std::uint32_t> read_plane() override;

  std::uint64_t cycle() const override { return api_.cycle(model_.get()); }
  std::uint64_t sticky() const override { return counter(kStickyCounter); }

  void write_coverage(const std::filesystem::path& file) override {
    if (!api_.write_coverage(model_.get(), file.c_str()))
      throw std::logic_error("the model counts no coverage");
  }

 private:
  std::uint64_t counter(std::uint32_t index) const { return api_.counter(model_.get(), index); }

  void open_trace(const TraceWindow& window) {
    if (!api_.trace_open(model_.get(), window.file.c_str(), window.from, window.to)) {
      throw std::runtime_error("cannot write a waveform to " + window.file.string());
    }
  }

  GnomonModelRun new_run(std::span<const Word> words) const {
    GnomonModelRun run{};
    run.words = words.data();
    run.word_count = words.size();
    return run;
  }

  void run_to_end(GnomonModelRun& run) {
    quiet_since_ = cycle();
    for (;;) {
      const int stop = run_slice(run, options_.slice);
      if (ended(stop)) return;
      report(run.words_taken);
    }
  }

  /// Runs for at most `cycles`, keeps the results, and throws if the run must not go on.
  int run_slice(GnomonModelRun& run, std::uint64_t cycles);
  void check_limits(const GnomonModelRun& run, std::uint64_t now) const;
  std::string state(const GnomonModelRun& run) const;

  void report(std::uint64_t words_of_run) const {
    if (options_.progress) options_.progress({cycle(), words_taken_ + words_of_run, results_given_});
  }

  golden::HardwareConfig config_;
  RtlOptions options_;
  std::shared_ptr<const ModelLibrary> library_;
  const GnomonModelApi& api_;
  std::unique_ptr<void, void (*)(void*)> model_;
  std::vector<Word> results_;
  std::vector<std::uint64_t> result_cycles_;
  std::vector<Word> room_ = std::vector<Word>(kResultRoom);  ///< where the model puts results
  std::vector<std::uint64_t> cycle_room_ = std::vector<std::uint64_t>(kResultRoom);
  std::uint64_t words_taken_ = 0, results_given_ = 0;
  std::uint64_t quiet_since_ = 0;  ///< cycle at which a word last moved
};

int RtlEngineImpl::run_slice(GnomonModelRun& run, std::uint64_t cycles) {
  const std::uint64_t taken_before = run.words_taken;
  run.results = room_.data();
  run.result_cycles = cycle_room_.data();
  run.result_capacity = room_.size();
  run.result_count = 0;
  run.max_cycles =
      std::min({cycles, options_.hang_cycles, options_.max_cycles - std::min(options_.max_cycles, cycle())});
  const int stop = api_.run(model_.get(), &run);
  const auto count = static_cast<std::ptrdiff_t>(run.result_count);
  results_.insert(results_.end(), room_.begin(), room_.begin() + count);
  result_cycles_.insert(result_cycles_.end(), cycle_room_.begin(), cycle_room_.begin() + count);
  results_given_ += run.result_count;

  const std::uint64_t now = cycle();
  if (stop == GNOMON_STOP_FAULT) {
    throw RtlFault("the RTL stopped at cycle " + std::to_string(now) + ": " + api_.fault(model_.get()));
  }
  if (run.result_count != 0 || run.words_taken != taken_before) quiet_since_ = now;
  if (options_.abort && options_.abort->load(std::memory_order_relaxed)) {
    throw Aborted("interrupted at cycle " + std::to_string(now));
  }
  if (!ended(stop)) check_limits(run, now);
  return stop;
}

void RtlEngineImpl::check_limits(const GnomonModelRun& run, std::uint64_t now) const {
  if (now >= options_.max_cycles) throw CycleLimit("stopped after " + std::to_string(now) + " cycles");
  if (now - quiet_since_ >= options_.hang_cycles) {
    throw HangError("the hardware hangs: no word moved for " + std::to_string(now - quiet_since_) +
                    " cycles; " + state(run));
  }
}

std::string RtlEngineImpl::state(const GnomonModelRun& run) const {
  std::string text = "cycle " + std::to_string(cycle()) + ", " +
                     std::to_string(words_taken_ + run.words_taken) + " words taken, " +
                     std::to_string(run.word_count - run.words_taken) + " waiting, " +
                     std::to_string(results_given_) + " results given, " + std::to_string(counter(0)) +
                     " commands begun, idle=" + (api_.idle(model_.get()) ? "1" : "0") + ", cycles so far:";
  for (const auto& [name, count] : counters().cycles) {
    if (count != 0) text += " " + name + "=" + std::to_string(count);
  }
  return text;
}

std::vector<std::uint32_t> RtlEngineImpl::read_plane() {
  const std::vector<Word> words = plane_commands(config_);

  // The hardware is read through its own port and then put back, so that no counter or command index shows
  // it.
  const std::vector<Word> pending = std::exchange(results_, {});
  const std::vector<std::uint64_t> pending_cycles = std::exchange(result_cycles_, {});
  const std::uint64_t given = results_given_;
  if (!api_.save(model_.get())) throw std::logic_error("a model that counts coverage cannot be read back");
  GnomonModelRun run = new_run(words);
  run.until_idle = 1;
  run_to_end(run);
  std::vector<std::uint32_t> plane = plane_of(config_, results_);
  api_.restore(model_.get());
  results_ = pending;
  result_cycles_ = pending_cycles;
  results_given_ = given;
  return plane;
}

}  // namespace

ModelSpec model_spec(const golden::HardwareConfig& config, const RtlOptions& options) {
  return {.config = config,
          .trace = options.trace_model || options.trace.has_value(),
          .coverage = options.coverage,
          .assertions = options.assertions,
          .plain_bit_operations = options.plain_bit_operations,
          .quick_build = options.quick_build,
          .memory_latency = options.memory_latency,
          .memory_stall_seed = options.memory_stall_seed,
          .slb_dividers = options.slb_dividers,
          .defines = options.defines};
}

std::unique_ptr<RtlEngine> make_rtl_engine(const golden::HardwareConfig& config, const RtlOptions& options,
                                           ModelCache& cache) {
  if (const auto error = config.check()) throw std::invalid_argument(*error);
  return std::make_unique<RtlEngineImpl>(config, options, cache.load(model_spec(config, options)));
}

std::unique_ptr<RtlEngine> make_rtl_engine(const golden::HardwareConfig& config, const RtlOptions& options) {
  ModelCache cache;
  return make_rtl_engine(config, options, cache);
}

}  // namespace gnomon::sim
