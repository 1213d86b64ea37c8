// SPDX-License-Identifier: Apache-2.0
// The hardware whose area is estimated. Theory: docs/area.md, "What is counted".
#pragma once

#include <gnomon/golden/config.hpp>
#include <string>

#include "host/base/result.hpp"
#include "host/config/settings.hpp"

namespace gnomon::cli {

/// The hardware of a technique as the parameters alone have it; what follows from a scene is taken as for one
/// of default size. Without any unit for a software technique. Fails where it would be no legal hardware.
Result<golden::HardwareConfig> area_hardware(const config::Settings& settings, const std::string& technique);

}  // namespace gnomon::cli
