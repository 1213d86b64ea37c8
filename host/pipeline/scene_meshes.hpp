// SPDX-License-Identifier: Apache-2.0
// A run's surfaces and shadows as meshes for other programs.
#pragma once

#include <memory>
#include <span>

#include "host/base/result.hpp"
#include "host/pipeline/lit_scene.hpp"
#include "host/pipeline/run.hpp"
#include "host/pipeline/stages.hpp"
#include "host/pipeline/technique_job.hpp"
#include "host/report/output_directory.hpp"

namespace gnomon::pipeline {

/// Writes the formats that the request asks for: mesh.obj, which holds no shadows, and mesh.ply, one for each
/// technique, those after the first as mesh-<technique>.ply.
Result<void> write_meshes(const report::OutputDirectory& output, const RunRequest& request,
                          const LitScene& scene, std::span<const std::unique_ptr<TechniqueJob>> jobs,
                          Stages& stages);

}  // namespace gnomon::pipeline
