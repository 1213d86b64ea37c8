// SPDX-License-Identifier: Apache-2.0
// The options of gnomon sweep that estimate the area of its points (docs/sweep.md, "Area").
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/command.hpp"
#include "host/sweep/store.hpp"
#include "host/sweep/task.hpp"

namespace gnomon::cli {

class SweepArea {
 public:
  struct Counts {
    std::size_t points = 0;  ///< that have figures now
    std::size_t units = 0;   ///< that they are made of, each counted once
    int runs = 0;            ///< of the tools: units that were not in the cache
  };

  /// --area and --seeds; --area excludes those of `others`.
  void add_to(CLI::App& command, const std::vector<CLI::Option*>& others);
  bool asked() const { return asked_; }
  /// Adds figures to all done points of `tasks` that have hardware, `jobs` units at a time (0: one a core).
  /// Fails where Yosys or nextpnr-ice40 does; throws Interrupted after Ctrl-C.
  Result<Counts> run(Context& context, const std::vector<sweep::Task>& tasks, sweep::Store& store,
                     unsigned jobs) const;

 private:
  bool asked_ = false;
  int seeds_ = 0;
};

}  // namespace gnomon::cli
