// SPDX-License-Identifier: Apache-2.0
// The sweep's page: its data, put into the template.
#include "host/sweep/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/report/page_assets.hpp"
#include "host/sweep/confirm.hpp"
#include "host/sweep/figures.hpp"
#include "host/sweep/page_assets.hpp"

namespace gnomon::sweep {
namespace {

namespace mustache = kainjow::mustache;
using Json = nlohmann::ordered_json;

/// Figures that at least one point has.
std::vector<Figure> present_figures(const std::vector<Row>& rows) {
  std::vector<Figure> present;
  for (const Figure& figure : plotted_figures()) {
    const std::string name(figure.name);
    if (std::ranges::any_of(rows, [&](const Row& row) { return row.figures.contains(name); }))
      present.push_back(figure);
  }
  return present;
}

Json point_of(const Row& row, const std::vector<Varied>& varied, const std::vector<Figure>& figures,
              bool marks) {
  Json point = {{"scene", row.scene}, {"flags", row.flags}, {"mark", marks && is_published(row)}};
  point["configuration"] = Json::object();
  for (const Varied& parameter : varied)
    point["configuration"][parameter.key] = parameter_text(row, parameter.key);
  if (const auto label = row.labels.find(std::string(kConfirmLabel)); label != row.labels.end())
    point["confirmed"] = label->second;
  point["figures"] = Json::object();
  for (const Figure& figure : figures) {
    const auto value = row.figures.find(std::string(figure.name));
    if (value != row.figures.end()) point["figures"][std::string(figure.name)] = value->second;
  }
  return point;
}

/// The first of `wanted` that is among the figures, else the figure at `otherwise`.
std::string choose(const std::vector<Figure>& figures, std::initializer_list<std::string_view> wanted,
                   std::size_t otherwise) {
  for (const std::string_view name : wanted) {
    if (std::ranges::find(figures, name, &Figure::name) != figures.end()) return std::string(name);
  }
  return figures.empty() ? "" : std::string(figures[std::min(otherwise, figures.size() - 1)].name);
}

std::string choose_or_none(const std::vector<Figure>& figures, std::string_view wanted) {
  return std::ranges::find(figures, wanted, &Figure::name) == figures.end() ? "" : std::string(wanted);
}

Json data_of(const std::vector<Row>& done) {
  const std::vector<Varied> varied = varied_parameters(done);
  const std::vector<Figure> figures = present_figures(done);
  Json data = {{"points", Json::array()}, {"figures", Json::array()}, {"axes", Json::array()}};
  data["y"] = choose(figures, {"errors.fixed.border_voxels", "errors.fixed.boundary_displacement"}, 0);
  data["x"] = choose(figures, {"memory.format_bits", "memory.hardware_bits", "model.cycles"}, 1);
  data["z"] = choose_or_none(figures, "area.luts");
  for (const Figure& figure : figures)
    data["figures"].push_back({{"name", figure.name}, {"label", figure.label}});
  for (const Varied& parameter : varied)
    data["axes"].push_back({{"key", parameter.key}, {"values", parameter.values}});
  const bool marks = marks_published(done);
  std::vector<std::string> scenes;
  for (const Row& row : done) {
    data["points"].push_back(point_of(row, varied, figures, marks));
    if (std::ranges::find(scenes, row.scene) == scenes.end()) scenes.push_back(row.scene);
  }
  data["scenes"] = scenes;
  return data;
}

std::string cell(const Row& row, const std::string& figure) {
  const auto value = row.figures.find(figure);
  return value == row.figures.end() ? "–" : fmt::format("{:.10g}", value->second);
}

/// A line for each point that was run on the hardware too, flagged ones first.
mustache::data confirmed_rows(const std::vector<Row>& done) {
  mustache::data lines(mustache::data::type::list);
  for (const bool flagged : {true, false}) {
    for (const Row& row : done) {
      const auto label = row.labels.find(std::string(kConfirmLabel));
      if (label == row.labels.end() || (label->second != kAgrees) != flagged) continue;
      mustache::data line(mustache::data::type::object);
      line.set("flags", row.flags);
      line.set("verdict", label->second);
      line.set("flagged", flagged);
      line.set("model", cell(row, "model.cycles"));
      line.set("rtl", cell(row, "rtl.cycles"));
      const auto error = row.figures.find("confirm.cycle_error");
      line.set("error", error == row.figures.end() ? "–" : fmt::format("{:.4f} %", 100 * error->second));
      line.set("words", cell(row, "confirm.words"));
      line.set("differing", cell(row, "confirm.differing"));
      lines << line;
    }
  }
  return lines;
}

/// JSON that can stand in a script element: nothing in it ends the element.
std::string embedded(const Json& data) {
  std::string text;
  for (const char c : data.dump()) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

}  // namespace

std::string sweep_page(const std::string& title, const std::vector<Row>& rows) {
  std::vector<Row> done;
  mustache::data failures(mustache::data::type::list);
  bool failed = false;
  for (const Row& row : rows) {
    if (!row.failed()) {
      done.push_back(row);
      continue;
    }
    failed = true;
    mustache::data failure(mustache::data::type::object);
    failure.set("flags", row.flags);
    failure.set("error", row.error);
    failures << failure;
  }
  mustache::data view(mustache::data::type::object);
  view.set("title", title);
  view.set("summary", fmt::format("{} points measured, {} failed", done.size(), rows.size() - done.size()));
  view.set("style", std::string(report::page_css()));
  view.set("plot_style", std::string(page_uPlot_min_css()));
  view.set("sweep_style", std::string(page_css()));
  view.set("data", embedded(data_of(done)));
  view.set("plot_script", std::string(page_uPlot_iife_min_js()));
  view.set("script", std::string(page_js()));
  const mustache::data confirmed = confirmed_rows(done);
  view.set("any_confirmed", confirmed.is_non_empty_list());
  view.set("confirmed", confirmed);
  view.set("failed", failed);
  view.set("failures", failures);
  mustache::mustache page{std::string(page_html())};
  if (!page.is_valid()) throw std::logic_error("sweep.html.mustache: " + page.error_message());
  return page.render(view);
}

}  // namespace gnomon::sweep
