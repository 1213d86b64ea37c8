// SPDX-License-Identifier: Apache-2.0
// Random command streams for the silhouette-line buffer that reach its corners, for golden tests and
// co-simulation.
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/unit.hpp>
#include <vector>

#include "tests/golden/slb/shapes.hpp"

namespace gnomon::golden::slb::testing {

/// One command before it becomes words.
struct Command {
  std::uint8_t op = 0;
  std::uint8_t flags = 0;
  std::uint32_t arg = 0;
  std::vector<Word> items;
};

struct StimulusOptions {
  int objects = 6;            ///< at most; at least one
  int queries = 200;          ///< in the whole stream, most of them on or near outlines
  double error_share = 0.05;  ///< of commands put in between that must be answered by an error
  bool read_back = true;      ///< read up to 256 of the plane's entries at the end, where something was drawn
};

/// The same seed and configuration give the same stream.
std::vector<Command> random_commands(std::uint64_t seed, const SlbConfig& config,
                                     const StimulusOptions& options = {});

/// Header and items of every command: op 63:56, flags 55:48, count 47:32, arg 31:0.
std::vector<Word> to_words(const std::vector<Command>& commands);

}  // namespace gnomon::golden::slb::testing
