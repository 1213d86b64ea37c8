// SPDX-License-Identifier: Apache-2.0
// A run as it might have been, with every field set.
#pragma once

#include "host/report/run_record.hpp"

namespace gnomon::report {

RunRecord sample_record();
/// A directional light and a spot.
RunRecord lights_record();
/// The same run on the system engine.
RunRecord system_record();
/// The same run on the golden engine alone.
RunRecord golden_record();
/// The same scene on the silhouette-line buffer.
RunRecord slb_record();
/// The same scene in topology mode.
RunRecord topology_record();
/// The same run with a word that differs.
RunRecord failing_record();

}  // namespace gnomon::report
