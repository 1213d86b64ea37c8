// SPDX-License-Identifier: Apache-2.0
// Which known name somebody may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gnomon::config {

/// Damerau-Levenshtein distance (optimal string alignment): insertions, deletions, substitutions and swaps of
/// neighbours each count one.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// "did you mean 'x'?" for the nearest of `known`, which must not be empty; where none is near (more than a
/// third of the letters wrong), "expected one of a, b, c".
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}  // namespace gnomon::config
