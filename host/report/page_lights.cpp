// SPDX-License-Identifier: Apache-2.0
// Several lights, or a light of several views, one by one.
#include <fmt/format.h>

#include <string>

#include "host/report/page_sections.hpp"
#include "host/report/page_text.hpp"

namespace gnomon::report {
namespace {

std::string lists_text(const Json& topology) {
  if (topology.is_null()) return kNone;
  return number(topology.at("mean_list"), 2) + ", " + count(topology.at("longest_list"));
}

Json view_row(const std::string& light, const Json& view) {
  const Json& plane = view.at("plane");
  const Json& topology = view.at("topology");
  const Json& used = plane.is_null() ? topology : plane;
  return {{"light", light},
          {"view", view.at("name")},
          {"casters", count(view.at("casters"))},
          {"receivers", count(view.at("receivers"))},
          {"side", used.is_null() ? kNone : count(used.at("side"))},
          {"pitch", used.is_null() ? kNone : number(used.at("pitch"), 2)},
          {"hit", used.is_null() ? kNone : share(used.at("share_hit"))},
          {"voxels", plane.is_null() ? kNone : number(plane.at("voxels_per_entry_hit"), 2)},
          {"lists", lists_text(topology)}};
}

Json light_row(const std::string& number_of, const Json& light) {
  const Json& errors = light.at("errors");
  const auto among = [](const Json& method, const char* which) {
    return method.is_null() ? kNone : share(method.at(which).at("share"));
  };
  return {{"light", number_of},
          {"text", light_text(light)},
          {"shadow", share(light.at("shadow_share"))},
          {"not_reached", count(light.at("not_reached"))},
          {"unambiguous", among(errors.at("fixed"), "unambiguous")},
          {"steady", among(errors.at("fixed"), "steady")},
          {"unambiguous_double", among(errors.at("double"), "unambiguous")},
          {"all", among(errors.at("fixed"), "all")},
          {"boundary", number(errors.at("fixed").at("boundary_displacement"), 4)},
          {"pitch", number(errors.at("pitch"), 2)}};
}

}  // namespace

std::string light_text(const Json& light) {
  const auto vector = [&](const char* key) {
    const Json& v = light.at(key);
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.at(0).get<double>(), v.at(1).get<double>(),
                       v.at(2).get<double>());
  };
  if (light.at("type") == "directional") return "directional, travelling " + vector("direction");
  if (light.at("type") == "point") return "point at " + vector("position");
  return fmt::format("spot at {}, shining {}, {:.4g}° wide", vector("position"), vector("direction"),
                     light.at("angle").get<double>());
}

Json light_section(const Json& m) {
  const Json& lights = m.at("lights");
  const bool plain = lights.size() == 1 && lights.front().at("type") == "directional";
  if (plain) return {{"light_table", false}};
  Json rows = Json::array();
  Json views = Json::array();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::string name = std::to_string(i + 1);
    rows.push_back(light_row(name, lights[i]));
    for (const Json& view : lights[i].at("views")) views.push_back(view_row(name, view));
  }
  return {{"light_table", {{"rows", rows}, {"views", views}}}};
}

}  // namespace gnomon::report
