// SPDX-License-Identifier: Apache-2.0
// Any technique of the projection unit with a cubic frame buffer: its states are kept by the hardware and
// looked up (docs/frame-buffer.md).
#pragma once

#include "host/pipeline/technique.hpp"

namespace gnomon::pipeline {

/// The techniques of all views of a run, whose states then come from the frame buffer instead of result
/// words: a layer for each light. `techniques` and `views` run alike. Fails where there is no such frame
/// buffer, or a technique that has no states of voxels.
Result<std::vector<std::unique_ptr<Technique>>> keep_states(
    std::vector<std::unique_ptr<Technique>> techniques, std::span<const TechniqueInput> views);

}  // namespace gnomon::pipeline
