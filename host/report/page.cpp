// SPDX-License-Identifier: Apache-2.0
// report.html: the template filled in.
#include "host/report/page.hpp"

#include <fmt/format.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "host/report/page_assets.hpp"
#include "host/report/page_sections.hpp"

namespace gnomon::report {
namespace {

namespace mustache = kainjow::mustache;

std::string data_uri(const std::string& png) {
  using namespace boost::archive::iterators;
  using Encode = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text = "data:image/png;base64,";
  text.append(Encode(png.begin()), Encode(png.end()));
  return text.append((3 - png.size() % 3) % 3, '=');
}

/// Strings, booleans, lists and objects as the template engine takes them; null counts as false.
mustache::data to_mustache(const Json& json) {
  if (json.is_string()) return mustache::data(json.get<std::string>());
  if (json.is_boolean() || json.is_null()) return mustache::data(json.is_boolean() && json.get<bool>());
  if (json.is_array()) {
    mustache::data list(mustache::data::type::list);
    for (const Json& item : json) list << to_mustache(item);
    return list;
  }
  if (!json.is_object()) return mustache::data(json.dump());
  mustache::data object(mustache::data::type::object);
  for (const auto& [key, value] : json.items()) object.set(key, to_mustache(value));
  return object;
}

}  // namespace

std::string report_page(const Json& metrics, const Pictures& pictures) {
  const TechniquePictures& leading = pictures.techniques.at(0);
  Json view = {{"style", page_css()},
               {"script", page_js()},
               {"image", data_uri(leading.image)},
               {"reference", data_uri(pictures.reference)},
               {"error", data_uri(leading.error)},
               {"memory", false}};
  if (!leading.memory.empty()) view["memory"] = {{"picture", data_uri(leading.memory)}};
  view["others"] = Json::array();
  for (std::size_t i = 1; i < pictures.techniques.size(); ++i) {
    const TechniquePictures& other = pictures.techniques[i];
    view["others"].push_back({{"technique", other.technique},
                              {"id", fmt::format("picture-{}", i)},
                              {"image", data_uri(other.image)},
                              {"error", data_uri(other.error)}});
  }
  for (const Json& section : {summary_section(metrics), error_section(metrics), cycle_section(metrics),
                              stage_section(metrics), system_section(metrics), configuration_section(metrics),
                              model_section(metrics), technique_section(metrics), light_section(metrics)}) {
    view.update(section);
  }
  mustache::mustache page{std::string(page_html())};
  std::string html = page.is_valid() ? page.render(to_mustache(view)) : "";
  if (!page.error_message().empty()) throw std::logic_error("report template: " + page.error_message());
  return html;
}

}  // namespace gnomon::report
