// SPDX-License-Identifier: Apache-2.0
// The figures of one run as a sweep keeps them. Names: docs/sweep.md, "Results".
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace gnomon::sweep {

struct Measurement {
  std::map<std::string, double> figures;
  std::map<std::string, std::string> labels;
};

/// From what metrics.json holds: every number by its path, wall times under "seconds." and "host.".
Measurement measurement_of(const nlohmann::ordered_json& metrics);

/// Of a point measured by shared work: takes out what counts commands and questions of a run, and what is
/// read back from the plane.
void drop_unasked(Measurement& measured);

}  // namespace gnomon::sweep
