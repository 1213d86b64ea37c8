// SPDX-License-Identifier: Apache-2.0
// The whole system behind the interface of an engine.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/rtl_engine.hpp"
#include "sim/system/system_top.hpp"
#include "sim/top_model.hpp"

namespace gnomon::sim::system {

/// What answers the commands inside the system's hardware.
enum class HardwareModel : std::uint8_t {
  Top,     ///< the Verilated gnomon_top: registers, DMA, caches and units, on the bus by its AXI ports
  Core,    ///< the Verilated units, behind a front end in SystemC
  Golden,  ///< the golden model, a command word a cycle, behind the same front end
};

/// "top", "core", "golden".
std::string_view to_string(HardwareModel model);

struct SystemOptions {
  SystemConfig system;  ///< its limits are those of `rtl`
  HardwareModel hardware = HardwareModel::Top;
  RtlOptions rtl;          ///< the model; progress, abort and max_cycles in cycles of the system
  int cache_log2 = 0;      ///< of Top, as in ModelSpec
  int line_ids_log2 = 4;   ///< of Top, as in ModelSpec
  int axi_data_bits = 64;  ///< of Top, as in ModelSpec
};

/// What is submitted until a drain is one job, so it must hold whole commands. Its cycles are the system's,
/// since power-up. After a reset everything starts anew, firmware and time included.
class SystemEngine final : public RtlEngine {
 public:
  /// `inner` answers the commands inside the hardware; `clock` and exceptions as of System.
  SystemEngine(const SystemConfig& config, std::unique_ptr<golden::Engine> inner,
               std::span<const std::uint8_t> firmware, EngineClock clock = {});
  /// Of HardwareModel::Top: `hardware` is what the library was built for; of `rtl` seed and waveform count.
  SystemEngine(const SystemConfig& config, const golden::HardwareConfig& hardware,
               std::shared_ptr<const TopLibrary> library, RtlOptions rtl,
               std::span<const std::uint8_t> firmware);

  std::string_view name() const override { return "system"; }
  const golden::HardwareConfig& config() const override { return hardware_; }
  void submit(std::span<const Word> words) override;
  /// Throws RtlFault if the job or the firmware fails, and what the hardware throws.
  void drain(const golden::ResultSink& sink) override;
  void drain_timed(const TimedSink& sink) override;
  /// After a drain that has thrown: the results that lie in memory.
  void poll(const TimedSink& sink) override;
  /// As of the end of the last drain.
  golden::Counters counters() const override;
  void reset() override;
  /// Of Top a job like any other: no counter shows it, but commands after it have higher indices.
  std::vector<std::uint32_t> read_plane() override;

  std::uint64_t cycle() const override { return system_->statistics().cycles; }
  std::uint64_t sticky() const override;
  void write_coverage(const std::filesystem::path& file) override;

  /// Of Top with caches, as of the end of the last drain; else empty.
  const std::map<std::string, std::uint64_t>& cache_counters() const { return cache_counters_; }
  /// As System::set_event_log, also after resets.
  void set_event_log(std::function<void(const std::string& line)> sink);

  System& system() { return *system_; }
  const System& system() const { return *system_; }
  HardwareModel hardware() const;
  std::size_t firmware_bytes() const { return firmware_.size(); }
  /// Of all jobs since power-up, without their results.
  const std::vector<JobReport>& jobs() const { return jobs_; }

 private:
  void power_up();
  /// One job; throws if it fails.
  JobReport run(std::vector<Word> commands);
  std::uint64_t read_counter(std::uint32_t index);
  golden::Counters read_hardware_counters();
  /// All of them, as of now.
  void note_counters();

  SystemConfig system_config_;
  golden::HardwareConfig hardware_;
  std::vector<std::uint8_t> firmware_;
  // Either these two or the three below.
  std::unique_ptr<golden::Engine> inner_;
  EngineClock clock_;
  std::shared_ptr<const TopLibrary> library_;
  RtlOptions rtl_;
  std::unique_ptr<TopModel> model_;
  std::unique_ptr<System> system_;  // refers to what stands above
  std::function<void(const std::string&)> event_log_;
  std::vector<Word> waiting_;
  std::vector<JobReport> jobs_;
  golden::Counters counters_;  ///< of Top, as of the last drain
  std::map<std::string, std::uint64_t> cache_counters_;
  golden::Counters hidden_;  ///< of Top, what reading the plane has counted
  bool failed_ = false;      ///< since power-up, and its results are not yet given
};

/// With the firmware of this build. Throws as make_rtl_engine and System.
std::unique_ptr<SystemEngine> make_system_engine(const golden::HardwareConfig& config,
                                                 const SystemOptions& options, ModelCache& cache);
/// With the cache that the environment names.
std::unique_ptr<SystemEngine> make_system_engine(const golden::HardwareConfig& config,
                                                 const SystemOptions& options);

}  // namespace gnomon::sim::system
