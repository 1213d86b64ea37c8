// SPDX-License-Identifier: Apache-2.0
// Where a scene's figures are not those of its baseline, for better or for worse.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/regression/figures.hpp"

namespace gnomon::regression {

struct Difference {
  std::string figure;
  nlohmann::json was, is;  ///< null where only the other side has the figure
};

struct Comparison {
  std::size_t compared = 0;  ///< figures that either side has
  std::vector<Difference> differences;
};

/// Integers and hashes must be equal; numbers may differ by one part in 10^9, which no change of an answer
/// stays below: they are quotients of counts, and sums in an order that a compiler may choose.
Comparison compare(const Figures& was, const Figures& is);

/// "slb.cycles.FILL: was 5821, is 3011".
std::string to_text(const Difference& difference);

}  // namespace gnomon::regression
