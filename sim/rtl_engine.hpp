// SPDX-License-Identifier: Apache-2.0
// The rtl engine: the Verilated hardware behind the engine interface, cycle by cycle.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/model_cache.hpp"

namespace gnomon::sim {

using golden::Word;

/// How often a port of the hardware is held back.
struct PortStall {
  int open_per_256 =
      256;  ///< chance that the port is open in a block of cycles; 256 never holds it back, 0 always does
  int block_log2 = 0;  ///< a block has 2^block_log2 cycles, 0..31
};

/// Random holding back of both ports, the same for the same seed.
struct StallProfile {
  PortStall command{};
  PortStall result{};
  std::uint64_t seed = 1;
};

/// Cycles to write to a waveform, both ends included, counted from reset.
struct TraceWindow {
  std::uint64_t from = 0;
  std::uint64_t to = UINT64_MAX;
  std::filesystem::path file;  ///< FST
};

/// What a long run reports from time to time.
struct Progress {
  std::uint64_t cycles = 0;  ///< since reset
  std::uint64_t words = 0;   ///< command words taken since reset
  std::uint64_t results = 0;
};

struct RtlOptions {
  std::uint32_t seed = 1;  ///< of the random content of registers and memories at power-up
  StallProfile stalls;
  std::optional<TraceWindow> trace;
  /// Cycles without a word moving on either port, while there is work, until HangError. 0: what the largest
  /// plane could need.
  std::uint64_t hang_cycles = 0;
  /// Cycles since reset after which CycleLimit is thrown.
  std::uint64_t max_cycles = UINT64_MAX;
  /// Called every `slice` cycles and at the end of submit and drain.
  std::function<void(const Progress&)> progress;
  /// Looked at every `slice` cycles: if it has become true, Aborted is thrown. Not owned; may be set by a
  /// signal handler.
  const std::atomic<bool>* abort = nullptr;
  std::uint64_t slice = 1u << 18;

  // What model runs; the configuration comes with make_rtl_engine.
  int memory_latency = 1;     ///< as in ModelSpec
  int memory_stall_seed = 0;  ///< as in ModelSpec
  int slb_dividers = 2;       ///< as in ModelSpec
  bool trace_model = false;   ///< a model that can trace, also when `trace` is empty
  bool coverage = false;
  bool assertions = false;
  bool plain_bit_operations = false;
  bool quick_build = false;  ///< as in ModelSpec
  std::vector<std::string> defines;
};

/// Work is pending, and nothing has moved for RtlOptions::hang_cycles. The message says in what state.
class HangError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An assertion of the RTL failed; the message holds its text and the cycle.
class RtlFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// RtlOptions::max_cycles have passed.
class CycleLimit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// RtlOptions::abort was set.
class Aborted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An engine that knows at which cycle each result word left it. After an exception only reset() is of use.
/// read_plane throws std::logic_error if the model counts coverage.
class RtlEngine : public golden::Engine {
 public:
  /// Result words and, for each of them, the cycle since reset at which it was taken from the hardware.
  using TimedSink = std::function<void(std::span<const Word>, std::span<const std::uint64_t>)>;

  /// Gives the results so far that were not yet given, without waiting for more.
  virtual void poll(const TimedSink& sink) = 0;
  /// As golden::Engine::drain, with cycles.
  virtual void drain_timed(const TimedSink& sink) = 0;
  virtual std::uint64_t cycle() const = 0;   ///< cycles since reset
  virtual std::uint64_t sticky() const = 0;  ///< the sticky flags, without clearing them
  /// Writes Verilator's coverage data. Throws std::logic_error if the model was built without.
  virtual void write_coverage(const std::filesystem::path& file) = 0;
};

/// The model of `config` that the options ask for.
ModelSpec model_spec(const golden::HardwareConfig& config, const RtlOptions& options);

/// `config` must pass check(), else std::invalid_argument. ModelBuildError as ModelCache::load;
/// std::runtime_error if the waveform cannot be written.
std::unique_ptr<RtlEngine> make_rtl_engine(const golden::HardwareConfig& config, const RtlOptions& options,
                                           ModelCache& cache);
/// With the cache that the environment names.
std::unique_ptr<RtlEngine> make_rtl_engine(const golden::HardwareConfig& config, const RtlOptions& options);

}  // namespace gnomon::sim
