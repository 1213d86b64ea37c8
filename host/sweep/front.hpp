// SPDX-License-Identifier: Apache-2.0
// Which points no other one beats. Theory: docs/sweep.md, "Fronts".
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace gnomon::sweep {

/// For each point, true if it is on the Pareto front. `objectives[i]` are point i's, smaller is better, all
/// of the same length; a point with a value that is not finite takes no part.
std::vector<bool> pareto_front(std::span<const std::vector<double>> objectives);

}  // namespace gnomon::sweep
