// SPDX-License-Identifier: Apache-2.0
// Cycles that the hardware would take for a command stream, predicted at the golden engine's speed
// (docs/cycle-model.md). No result word depends on anything here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace gnomon::golden {

/// The memory behind the hardware's bus (docs/system-model.md, "Parameters"); times in cycles.
struct SystemTiming {
  int cache_log2 = 0;      ///< CACHE_LOG2: 0, or 12..16
  int line_ids_log2 = 4;   ///< LINE_IDS_LOG2: 3..5; only with a cache
  int axi_data_bits = 64;  ///< AXI_DATA_BITS: 64, 128, 256 or 512
  std::uint32_t bus_latency = 2;
  std::uint32_t latency = 20;  ///< of DRAM's controller and wires
  std::uint32_t banks = 8, row_bytes = 2048;
  std::uint32_t rcd = 2, rp = 2, cas = 2;
  std::uint32_t bytes_per_cycle = 8;
  std::uint64_t dram_bytes = std::uint64_t{256} << 20U;
  std::uint64_t job_words = 0;  ///< command words that lie in memory from the start; more do once submitted

  /// Nothing if the values are legal; else one line that says what is wrong.
  std::optional<std::string> check() const;
  bool operator==(const SystemTiming&) const = default;
};

/// What cycles depend on beside HardwareConfig. Names and meanings are those of the SystemVerilog parameters.
struct HardwareTiming {
  int memory_latency = 1;  ///< MEM_LATENCY, cycles of a read of the on-chip memories, 1..64
  int slb_dividers = 2;    ///< SLB_DIVIDERS, 1..3
  /// Commands come from memory and results go there; without, both ports are never held back.
  std::optional<SystemTiming> system = std::nullopt;

  /// Nothing if the values are legal; else one line naming the parameter, its value and the range.
  std::optional<std::string> check() const;
  bool operator==(const HardwareTiming&) const = default;
};

/// Whose work a cycle is, and what became of it (docs/command-stream.md, "Counters").
enum class Pass : std::uint8_t { Idle, Control, Clear, Project, Resolve, Read, Draw, Fill, Cover, Query };
enum class Cause : std::uint8_t { Busy, InputStarved, OutputBlocked, MemoryWait, Hazard, Idle };
inline constexpr std::size_t kPasses = 10, kCauses = 6;

/// Cycles by pass and cause.
class CycleTable {
 public:
  std::uint64_t& at(Pass pass, Cause cause) { return cells_[index(pass, cause)]; }
  std::uint64_t at(Pass pass, Cause cause) const { return cells_[index(pass, cause)]; }
  std::uint64_t of(Pass pass) const;  ///< all causes
  std::uint64_t total() const;
  /// "cycles.<PASS>.<CAUSE>", all 60: the keys of Counters::cycles.
  std::map<std::string, std::uint64_t> named() const;
  bool operator==(const CycleTable&) const = default;

 private:
  static constexpr std::size_t index(Pass pass, Cause cause) {
    return static_cast<std::size_t>(pass) * kCauses + static_cast<std::size_t>(cause);
  }
  std::array<std::uint64_t, kPasses * kCauses> cells_{};
};

/// The golden engine, which also predicts: counters().cycles holds the 60 cells of everything submitted so
/// far, to the end of its drain, with no port ever held back and the next word always there; IDLE is 0.
/// Results and events are those of make_golden_engine. `config` and `timing` must pass check(); throws
/// std::invalid_argument otherwise.
std::unique_ptr<Engine> make_timed_golden_engine(const HardwareConfig& config, const HardwareTiming& timing);

/// Executes the stream and gives the cycles alone.
CycleTable predict_cycles(const HardwareConfig& config, const HardwareTiming& timing,
                          std::span<const Word> words);

}  // namespace gnomon::golden
