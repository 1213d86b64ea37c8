// SPDX-License-Identifier: Apache-2.0
// Makes a failing stream short.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <span>
#include <vector>

#include "sim/rtl_engine.hpp"

namespace gnomon::sim {

/// Whether a stream still shows the fault.
using StillFails = std::function<bool(std::span<const Word>)>;

struct ShrinkOptions {
  int max_trials = 2000;
};

struct Shrunk {
  std::vector<Word>
      stream;  ///< fails, and no single command or item can be left out (unless the trials ran out)
  int trials = 0;
};

/// Delta debugging: leaves out ever smaller groups of commands, then of items. `stream` must fail (else
/// std::invalid_argument) and hold whole commands.
Shrunk shrink(std::span<const Word> stream, const StillFails& still_fails, const ShrinkOptions& options = {});

/// For streams on which the rtl engine and the reference differ: fresh engines for every trial. `reference`
/// and `rtl` make them.
StillFails differs(std::function<std::unique_ptr<golden::Engine>()> reference,
                   std::function<std::unique_ptr<RtlEngine>()> rtl);

}  // namespace gnomon::sim
