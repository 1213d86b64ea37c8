// SPDX-License-Identifier: Apache-2.0
// Command streams for tests and co-simulation: the same words for the same seed on every machine.
#pragma once

#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <string>
#include <vector>

namespace gnomon::stimulus {

struct Options {
  std::uint64_t seed = 1;
  int commands = 100;        ///< about this many; some steps add two or three
  int max_items = 64;        ///< of one command
  int illegal_percent = 10;  ///< share of commands in error, or of random bits
  int extreme_percent = 15;  ///< share of register settings at the ends of their ranges
};

/// A random stream: registers, projections, resolves of what was projected and of other voxels, clears,
/// fences, reads, NOPs and commands in error; with EN_SLB as many commands of the silhouette-line buffer,
/// objects and queries in their sequence, with the others between them. It always ends with a FENCE. `config`
/// must be legal.
std::vector<golden::Word> random_stream(const golden::HardwareConfig& config, const Options& options);

struct DirectedStream {
  std::string name;
  std::vector<golden::Word> words;
};

/// One stream for each situation that random streams meet too rarely or too vaguely.
std::vector<DirectedStream> directed_streams(const golden::HardwareConfig& config);

}  // namespace gnomon::stimulus
