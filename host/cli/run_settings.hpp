// SPDX-License-Identifier: Apache-2.0
// All parameters, as the main job takes them.
#pragma once

#include "host/config/settings.hpp"
#include "host/pipeline/run.hpp"

namespace gnomon::cli {

pipeline::RunSettings run_settings(const config::Settings& settings);

}  // namespace gnomon::cli
