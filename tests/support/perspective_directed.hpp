// SPDX-License-Identifier: Apache-2.0
// Directed streams of the perspective projection.
#pragma once

#include <vector>

#include "tests/support/stimulus.hpp"

namespace gnomon::stimulus {

/// One stream for each situation; `config` has EN_PERSPECTIVE, and topology mode's commands are among them if
/// it has EN_VPU_TOPOLOGY. Part of directed_streams.
std::vector<DirectedStream> perspective_directed_streams(const golden::HardwareConfig& config);

}  // namespace gnomon::stimulus
