// SPDX-License-Identifier: Apache-2.0
// A small set of hardware builds in which every pair of parameter values meets.
#pragma once

#include <gnomon/golden/config.hpp>
#include <vector>

namespace gnomon::stimulus {

/// Lowest, default and highest value of each parameter: every pair of values that some legal build has occurs
/// in at least one of the returned builds. All are legal; the order is fixed, the first is the default build.
std::vector<golden::HardwareConfig> covering_array();

/// Every legal build of the values above; what covering_array() chooses from.
std::vector<golden::HardwareConfig> corner_configs();

}  // namespace gnomon::stimulus
