// SPDX-License-Identifier: Apache-2.0
// Directed streams for the silhouette-line buffer, one a situation.
#pragma once

#include <gnomon/golden/config.hpp>
#include <vector>

#include "tests/support/stimulus.hpp"

namespace gnomon::stimulus {

/// `config` must have EN_SLB. Every stream ends with a FENCE.
std::vector<DirectedStream> slb_directed_streams(const golden::HardwareConfig& config);

}  // namespace gnomon::stimulus
