// SPDX-License-Identifier: Apache-2.0
// Technique voxel-offset: the projection unit alone, in offset mode (docs/vpu.md).
#pragma once

#include "host/pipeline/technique.hpp"

namespace gnomon::pipeline {

Result<std::unique_ptr<Technique>> make_voxel_offset(const RunSettings& settings,
                                                     const TechniqueInput& input);

}  // namespace gnomon::pipeline
