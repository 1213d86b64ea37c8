// SPDX-License-Identifier: Apache-2.0
// Parts of metrics.json that stand in it more than once: for the run, for each light, for each view.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/report/run_record.hpp"

namespace gnomon::report {

using Json = nlohmann::ordered_json;
using Events = std::map<std::string, std::uint64_t>;

/// part / whole, null where there is no whole: JSON knows no NaN.
Json ratio(double part, double whole);
Json ratio(std::uint64_t part, std::uint64_t whole);
Json vector_json(const Vec3& v);

/// 0 where it was not counted.
std::uint64_t event(const Events& events, const std::string& name);

Json plane_json(const std::optional<PlaneRecord>& plane, const Events& events);
Json topology_json(const std::optional<TopologyRecord>& topology, const Events& events);
Json slb_json(const std::optional<SlbRecord>& slb, const Events& events);
Json software_json(const std::optional<SoftwareRecord>& software);
std::uint64_t topology_bits(const TopologyRecord& record);
/// The bits that docs/frame-buffer.md, "Memory", gives; 0 without one.
std::uint64_t frame_buffer_bits(const golden::HardwareConfig& hardware);

Json counts_json(const MislabelCounts& counts);
Json errors_json(const ErrorsRecord& errors);
Json exact_json(const ExactRecord& exact);

/// null without.
Json system_json(const std::optional<SystemRecord>& system);

/// All lights with their errors and views.
Json lights_json(const RunRecord& record);

}  // namespace gnomon::report
