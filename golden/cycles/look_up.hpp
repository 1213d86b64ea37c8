// SPDX-License-Identifier: Apache-2.0
// When LOOKUP_FRAME takes its items and gives its words (docs/cycle-model.md, "Frame buffer").
#pragma once

#include <gnomon/golden/cycles.hpp>
#include <vector>

#include "run.hpp"

namespace gnomon::golden::cycles {

class LookUp {
 public:
  explicit LookUp(const HardwareTiming& timing);

  /// Items of a command, offered one after the other from `now` on; `ends`: the last of them is the command's
  /// last. Returns the cycle after the last one was taken.
  Cycle items(std::size_t count, bool ends, bool brick, Cycle now, Run& run);

 private:
  Cycle item(bool last, bool brick, Cycle now, Run& run);

  Cycle latency_;
  std::vector<Cycle> left_;  ///< when each place of the read port's queue was left last
  std::size_t items_ = 0;
  Cycle before_ = 0;        ///< when the item before left the queue
  std::size_t states_ = 0;  ///< in the word being collected
};

}  // namespace gnomon::golden::cycles
