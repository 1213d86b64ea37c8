// SPDX-License-Identifier: Apache-2.0
// Commands of the silhouette-line buffer, one after the other without end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <vector>

#include "tests/support/random.hpp"

namespace gnomon::stimulus {

class SlbSource {
 public:
  /// `max_items` points a QUERY; `illegal_percent` of the commands are in error.
  SlbSource(const golden::HardwareConfig& config, std::uint64_t seed, int max_items, int illegal_percent);

  /// Header and items of the next command.
  std::vector<golden::Word> next();

 private:
  golden::HardwareConfig config_;
  Random random_;
  int max_items_, illegal_percent_;
  std::vector<std::vector<golden::Word>> commands_;
  std::size_t at_ = 0;
};

}  // namespace gnomon::stimulus
