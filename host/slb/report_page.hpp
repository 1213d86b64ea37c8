// SPDX-License-Identifier: Apache-2.0
// The error report as one page (docs/slb-cli.md, "Error report").
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gnomon::slb {

/// A picture in the page.
struct ReportPicture {
  std::string name;     ///< "F = 7"
  std::string caption;  ///< what is to be seen
  std::string png;      ///< the file's bytes
};

/// HTML that needs no other file. `metrics` is what metrics.json holds; pictures: the whole plane first,
/// then details.
std::string report_page(const nlohmann::ordered_json& metrics, const std::vector<ReportPicture>& pictures);

/// Displacement against memory of the buffer and of shadow maps, both axes logarithmic, as inline SVG.
std::string error_chart(const nlohmann::ordered_json& points);

}  // namespace gnomon::slb
