// SPDX-License-Identifier: Apache-2.0
// All techniques by name.
#include "host/pipeline/technique.hpp"

#include <fmt/format.h>

#include "host/pipeline/slb_technique.hpp"
#include "host/pipeline/voxel_offset.hpp"
#include "host/pipeline/voxel_topology.hpp"

namespace gnomon::pipeline {

Result<std::unique_ptr<Technique>> make_technique(const RunSettings& settings, const TechniqueInput& input) {
  if (settings.technique == "voxel-offset") return make_voxel_offset(settings, input);
  if (settings.technique == "voxel-topology") return make_voxel_topology(settings, input);
  if (settings.technique == "slb") return make_slb(settings, input, false);
  if (settings.technique == "slb+voxel") return make_slb(settings, input, true);
  return fail(
      fmt::format("technique={} is unknown, expected one of voxel-offset, voxel-topology, slb, slb+voxel",
                  settings.technique));
}

}  // namespace gnomon::pipeline
