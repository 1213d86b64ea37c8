// SPDX-License-Identifier: Apache-2.0
// From the two crossings of a pixel's major borders to the bits of a line (docs/slb.md, "Encoding a line").
#pragma once

#include <gnomon/golden/slb/edge_walker.hpp>

namespace gnomon::golden::slb {

/// `low` and `high` are where the edge meets M = 0 and M = 1 of the pixel whose minor index is `cell`.
Line encode_line(const EdgeSetup& edge, const Position& low, const Position& high, std::int64_t cell,
                 const SlbConfig& config);

/// The stored crossing lies halfway between two codes: F = S, and the line could have stored its crossing of
/// M = 0 as well, so that cross = 1 is free to mean this.
bool reads_halfway(const Line& line, const SlbConfig& config);

}  // namespace gnomon::golden::slb
