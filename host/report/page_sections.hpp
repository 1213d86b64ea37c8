// SPDX-License-Identifier: Apache-2.0
// What the page's template shows, section by section: figures of metrics.json put into words.
#pragma once

#include <nlohmann/json.hpp>

namespace gnomon::report {

using Json = nlohmann::ordered_json;

Json summary_section(const Json& metrics);        ///< title, verdict, key figures
Json error_section(const Json& metrics);          ///< error against run time
Json cycle_section(const Json& metrics);          ///< cycles by pass and cause
Json stage_section(const Json& metrics);          ///< times of the host's stages
Json system_section(const Json& metrics);         ///< firmware, bus, DRAM of the system engine
Json configuration_section(const Json& metrics);  ///< parameters, hardware, formats, registers, versions
Json model_section(const Json& metrics);          ///< objects, warnings, voxels, plane
Json technique_section(const Json& metrics);      ///< several techniques side by side
Json light_section(const Json& metrics);          ///< several lights, or a light of several views, one by one

}  // namespace gnomon::report
