// SPDX-License-Identifier: Apache-2.0
// Random programs of topology mode as the words of a command stream.
#pragma once

#include <cstdint>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <limits>
#include <vector>

namespace gnomon::rtl_test::topology {

struct StreamOptions {
  std::uint64_t seed = 1;
  int commands = 30;
  /// Chance that a command is followed by one of any op near this mode's, with flags, counts and arguments
  /// that may be in error.
  int doubtful_percent = 0;
  /// That all quads together may meet; those beyond are left out. Each takes a cycle, and a quad that is too
  /// large for a record still tells every entry of its box.
  std::int64_t most_entries = std::numeric_limits<std::int64_t>::max();
};

/// A random_program for hardware with topology mode, and a FENCE: under directional lights, and where the
/// hardware has the perspective projection mostly under spots and point lights.
std::vector<golden::Word> program_stream(const golden::HardwareConfig& config, const StreamOptions& options);

}  // namespace gnomon::rtl_test::topology
