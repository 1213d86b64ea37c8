// SPDX-License-Identifier: Apache-2.0
// Width formulas as docs/number-formats.md writes them.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace gnomon::golden_test {

/// Value of a sum of terms such as `D + 2P + 6`, `N − 1`, `f + max(P + 1, N)`: integers, one-letter symbols
/// with an optional integer factor before them, and max of two sums. Throws std::invalid_argument on anything
/// else.
int evaluate(std::string_view formula, const std::map<char, int>& symbols);

}  // namespace gnomon::golden_test
