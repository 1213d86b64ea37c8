// SPDX-License-Identifier: Apache-2.0
// Legal loops that cast no shadow, so that nobody wonders why.
#pragma once

#include <string>
#include <vector>

#include "host/slb/loop_scene.hpp"

namespace gnomon::slb {

/// One line each, by place: clockwise loops that lie in no other loop of their object, loops without area,
/// objects without loops, a scene without objects. Of each kind the first three, and how many more there are.
std::vector<std::string> loops_that_cast_nothing(const LoopScene& scene, int side);

}  // namespace gnomon::slb
