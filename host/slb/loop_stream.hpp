// SPDX-License-Identifier: Apache-2.0
// Flat casters and receivers as a command stream, and what its results say.
#pragma once

#include <gnomon/golden/config.hpp>
#include <gnomon/golden/engine.hpp>
#include <gnomon/golden/slb/formats.hpp>
#include <gnomon/golden/slb/query.hpp>
#include <span>
#include <vector>

#include "host/slb/fixed_point.hpp"

namespace gnomon::slb {

/// Clears the plane, draws the casters one after the other (ids count modulo 256; a caster without loops is
/// left out), asks all queries at bias 0, reads the plane's entries if asked to, and ends with a fence.
std::vector<golden::Word> loop_stream(std::span<const FixedCaster> casters,
                                      std::span<const golden::slb::QueryPoint> queries,
                                      const golden::HardwareConfig& config, bool read_entries);

/// The results of such a stream.
struct LoopResults {
  std::vector<golden::slb::QueryAnswer> answers;  ///< in the order of the queries
  std::vector<golden::slb::Entry> entries;        ///< row-major; empty unless asked for
};
/// Throws std::logic_error if the results are not those of such a stream.
LoopResults decode_results(std::span<const golden::Word> results, std::size_t queries,
                           const golden::HardwareConfig& config);

}  // namespace gnomon::slb
