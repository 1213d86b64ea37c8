// SPDX-License-Identifier: Apache-2.0
// From the figures of a run to those that it is remembered by.
#include "host/regression/figures.hpp"

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace gnomon::regression {
namespace {

using Json = nlohmann::ordered_json;

/// Where an error figure stands in metrics.json, below errors.fixed.
struct ErrorFigure {
  std::string_view name, pointer;
};
constexpr std::array<ErrorFigure, 4> kErrors{{{"mislabelled", "/all/share"},
                                              {"mislabelled_unambiguous", "/unambiguous/share"},
                                              {"mislabelled_samples", "/samples/share"},
                                              {"displacement", "/boundary_displacement"}}};

void add_technique(const Json& run, const std::string& results, Figures& figures) {
  const std::string prefix = run.at("technique").get<std::string>() + ".";
  const std::string cycles_prefix = prefix + "cycles.";
  figures[prefix + "words"] = run.at("compare").at("words");
  figures[prefix + "results"] = results;
  if (!run.at("cycles").is_null()) {
    for (const auto& [pass, cycles] : run.at("cycles").at("by_pass").items()) {
      if (pass != "IDLE") figures[cycles_prefix + pass] = cycles.at("total");
    }
  }
  const Json& errors = run.at("errors").at("fixed");
  for (const ErrorFigure& figure : kErrors)
    figures[prefix + "error." + std::string(figure.name)] =
        errors.at(Json::json_pointer(std::string(figure.pointer)));
}

}  // namespace

Figures figures_of(const nlohmann::ordered_json& metrics, std::span<const std::string> results) {
  const Json& several = metrics.at("techniques");
  const std::size_t techniques = several.empty() ? 1 : several.size();
  if (results.size() != techniques) throw std::invalid_argument("one hash a technique is needed");
  Figures figures;
  for (std::size_t i = 0; i < techniques; ++i)
    add_technique(several.empty() ? metrics : several[i], results[i], figures);
  return figures;
}

}  // namespace gnomon::regression
