// SPDX-License-Identifier: Apache-2.0
// Technique voxel-topology: beams against the quads between voxels (docs/vpu-topology.md).
#pragma once

#include "host/pipeline/technique.hpp"

namespace gnomon::pipeline {

Result<std::unique_ptr<Technique>> make_voxel_topology(const RunSettings& settings,
                                                       const TechniqueInput& input);

}  // namespace gnomon::pipeline
