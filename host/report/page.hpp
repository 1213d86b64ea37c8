// SPDX-License-Identifier: Apache-2.0
// report.html: one file that shows a run, from its metrics and its pictures alone.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace gnomon::report {

/// PNG files, byte for byte.
struct Pictures {
  std::string image, reference, error;
  std::string memory{};  ///< of the silhouette-line buffer; empty if there is none
};

/// The page. `metrics` is what metrics_json gives (or a metrics.json read back): every figure shown is one of
/// its keys, or a sum or quotient of them. Nothing is loaded from elsewhere; without scripts only the copy
/// button is missing. Throws nlohmann::json::exception where `metrics` lacks a key.
std::string report_page(const nlohmann::ordered_json& metrics, const Pictures& pictures);

}  // namespace gnomon::report
