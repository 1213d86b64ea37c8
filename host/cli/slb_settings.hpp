// SPDX-License-Identifier: Apache-2.0
// The parameters of the silhouette-line buffer, as the planner takes them.
#pragma once

#include "host/config/settings.hpp"
#include "host/plan/slb_settings.hpp"

namespace gnomon::cli {

plan::SlbSettings slb_settings(const config::Settings& settings);

}  // namespace gnomon::cli
