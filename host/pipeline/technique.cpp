// SPDX-License-Identifier: Apache-2.0
// All techniques by name.
#include "host/pipeline/technique.hpp"

#include <fmt/format.h>

#include "host/pipeline/voxel_offset.hpp"

namespace gnomon::pipeline {

Result<std::unique_ptr<Technique>> make_technique(const RunSettings& settings, const TechniqueInput& input) {
  if (settings.technique == "voxel-offset") return make_voxel_offset(settings, input);
  return fail(fmt::format("technique={} is unknown, expected voxel-offset", settings.technique));
}

}  // namespace gnomon::pipeline
