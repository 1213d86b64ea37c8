// SPDX-License-Identifier: Apache-2.0
// Values of metrics.json as the page writes them; null becomes a dash.
#pragma once

#include <string>
#include <string_view>

#include "host/report/page_sections.hpp"

namespace gnomon::report {

inline constexpr const char* kNone = "–";

std::string count(const Json& value);               ///< with thousands separated
std::string share(const Json& value);               ///< in per cent
std::string number(const Json& value, int digits);  ///< with `digits` behind the point
std::string seconds(const Json& value);
std::string plain(const Json& value);  ///< a parameter's value, strings without quotes
/// Wall time of a stage; a dash where it did not run.
std::string wall_text(const Json& metrics, std::string_view stage);
/// The configuration that every error figure stands next to, in one line.
std::string configuration_line(const Json& metrics);
/// What a light is, in a few words.
std::string light_text(const Json& light);
/// A line of a list of names and values.
Json row(std::string name, std::string value);

}  // namespace gnomon::report
