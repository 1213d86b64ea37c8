// SPDX-License-Identifier: Apache-2.0
// The parameters of the projection unit, as the planner takes them.
#pragma once

#include "host/config/settings.hpp"
#include "host/plan/vpu_plan.hpp"

namespace gnomon::cli {

plan::VpuSettings vpu_settings(const config::Settings& settings);

}  // namespace gnomon::cli
