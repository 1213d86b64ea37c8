// SPDX-License-Identifier: Apache-2.0
// Techniques slb and slb+voxel: silhouettes decide, alone or together with the projection unit
// (docs/planning.md, "Silhouette-line buffer").
#pragma once

#include "host/pipeline/technique.hpp"

namespace gnomon::pipeline {

/// The view must be a directional light's.
Result<std::unique_ptr<Technique>> make_slb(const RunSettings& settings, const TechniqueInput& input);
/// Where a pixel holds no fragment, the voxel's state decides.
Result<std::unique_ptr<Technique>> make_slb_with_voxels(const RunSettings& settings,
                                                        const TechniqueInput& input);

}  // namespace gnomon::pipeline
