// SPDX-License-Identifier: Apache-2.0
// From a specification to the points that it asks for. Theory: docs/sweep.md.
#pragma once

#include <span>
#include <vector>

#include "host/base/result.hpp"
#include "host/config/settings.hpp"
#include "host/sweep/spec.hpp"

namespace gnomon::sweep {

struct Point {
  std::size_t scene = 0;  ///< index into Spec::scenes
  config::Settings settings;
};

/// All points that hold the constraints, scene by scene: the axes' in the order of the sample, then the
/// list's. None comes twice. `scene_parameters`: what each scene file sets itself, which the specification
/// wins over. Fails where no point is left, or more than ten million combinations are asked for.
Result<std::vector<Point>> expand(const Spec& spec,
                                  std::span<const std::vector<config::Assignment>> scene_parameters);

}  // namespace gnomon::sweep
