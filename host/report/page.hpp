// SPDX-License-Identifier: Apache-2.0
// report.html: one file that shows a run, from its metrics and its pictures alone.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace gnomon::report {

// PNG files, byte for byte.
struct TechniquePictures {
  std::string technique, image, error;
  std::string memory{};  ///< of the silhouette-line buffer; empty if there is none
};
struct Pictures {
  std::string reference;
  std::vector<TechniquePictures> techniques;  ///< at least one; the first leads the page
};

/// The page. `metrics` is what metrics_json gives (or a metrics.json read back): every figure shown is one of
/// its keys, or a sum or quotient of them. Nothing is loaded from elsewhere; without scripts only the copy
/// button is missing. Throws where `metrics`
/// lacks a key or `pictures` a technique.
std::string report_page(const nlohmann::ordered_json& metrics, const Pictures& pictures);

}  // namespace gnomon::report
