// SPDX-License-Identifier: Apache-2.0
// Cells by Yosys and clocks by nextpnr on one FPGA family, iCE40: estimates, kept by content. Theory:
// docs/area.md.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/area/units.hpp"
#include "host/base/result.hpp"
#include "sim/toolchain.hpp"

namespace gnomon::area {

/// Cells of the family.
struct Cells {
  std::uint64_t luts = 0;        ///< SB_LUT4
  std::uint64_t carries = 0;     ///< SB_CARRY
  std::uint64_t flip_flops = 0;  ///< SB_DFF of every kind
  std::uint64_t dsps = 0;        ///< SB_MAC16
  std::uint64_t rams = 0;        ///< SB_RAM40_4K
  Cells& operator+=(const Cells& other);
  Cells operator*(std::uint64_t times) const;
  bool operator==(const Cells&) const = default;
};

/// After place and route with several seeds.
struct Clock {
  std::vector<double> mhz;  ///< by seed; empty where it does not fit the device
  std::uint64_t used = 0;   ///< logic cells, wrapper included
  std::uint64_t available = 0;
  bool fits() const { return !mhz.empty(); }
  double lowest() const;
  double median() const;  ///< the mean of the two in the middle of an even number
  double highest() const;
};

struct UnitEstimate {
  Unit unit;
  Cells cells;  ///< of one, with multipliers in DSP cells
  std::optional<Clock>
      clock;  ///< of one by itself, with multipliers in logic; nothing if it was not asked for
};

/// The modules of `unit` in the files that rtl_dir's gnomon.f names. Thread-safe.
class Estimator {
 public:
  /// Throws std::runtime_error where no cache can be made.
  explicit Estimator(sim::Toolchain tools = sim::Toolchain::from_environment());

  /// `seeds`: how often it is placed, from seed 1 on; 0: cells alone. Fails where Yosys or nextpnr-ice40 is
  /// not there or refuses the design, with its first complaint.
  Result<UnitEstimate> estimate(const Unit& unit, int seeds);
  /// Yosys and nextpnr runs so far; 0 means that all was in the cache.
  int runs() const { return runs_; }

 private:
  sim::Toolchain tools_;
  std::vector<std::string> listed_;  ///< files of gnomon.f
  std::atomic<int> runs_ = 0;
};

}  // namespace gnomon::area
