// SPDX-License-Identifier: Apache-2.0
// The error report as one page.
#include "host/slb/report_page.hpp"

#include <fmt/format.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <kainjow/mustache.hpp>
#include <stdexcept>

#include "host/report/numbers.hpp"
#include "host/report/page_assets.hpp"
#include "host/slb/buffer_picture.hpp"

namespace gnomon::slb {
namespace {

namespace mustache = kainjow::mustache;
using Json = nlohmann::ordered_json;

constexpr std::string_view kTemplate = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{{title}} – Gnomon silhouette-line buffer</title>
<style>{{{style}}}
.chart { width: 100%; max-width: 60rem; height: auto; font-size: 12px; }
.chart text { fill: var(--soft); }
.chart .grid { stroke: var(--line); }
.chart .buffer { fill: var(--stage); }
.chart .map { fill: var(--input); }
.plane { display: grid; gap: .9rem; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); }
.plane img { width: 100%; height: auto; image-rendering: pixelated; background: rgb({{lit}}); }
tbody th { white-space: nowrap; }
.swatch { display: inline-block; width: .9em; height: .9em; border: 1px solid var(--line); margin: 0 .3em 0 .8em; vertical-align: -.1em; }
</style>
</head>
<body>
<header>
  <p class="brand">Gnomon <span>silhouette-line buffer</span></p>
  <h1>{{title}}</h1>
  <p class="configuration">{{configuration}}</p>
  {{#verdict}}<p class="verdict {{class}}"><strong>{{text}}</strong></p>{{/verdict}}
</header>
<main>
<section>
  <h2>Error, memory, cycles</h2>
  <p>Mean displacement of the shadow's border in pixels of the plane: wrongly answered area over {{border}} px of border, against the polygons themselves.
  The buffer is compared with a shadow map of the plane's own resolution and with one 2<sup>F</sup> times finer on both axes.</p>
  <div class="scroll" role="region" tabindex="0" aria-label="Figures"><table>
    <thead>
      <tr><th rowspan="2">F, S</th><th colspan="3">displacement, px</th><th rowspan="2">buffer / finer map</th><th rowspan="2">plain map / buffer</th><th colspan="3">memory</th><th colspan="3">cycles to draw</th><th rowspan="2">cycles to ask {{queries}} points{{cycles_note}}</th><th rowspan="2">chains that did not fit</th></tr>
      <tr><th>buffer</th><th>plain map</th><th>2<sup>F</sup> finer</th><th>buffer</th><th>plain map</th><th>2<sup>F</sup> finer</th><th>buffer</th><th>plain map</th><th>2<sup>F</sup> finer</th></tr>
    </thead>
    <tbody>{{#rows}}<tr><th scope="row">{{widths}}</th><td>{{buffer}}</td><td>{{plain}}</td><td>{{fine}}</td><td>{{ratio}}</td><td>{{gain}}</td><td>{{buffer_memory}}</td><td>{{plain_memory}}</td><td>{{fine_memory}}</td><td>{{buffer_draw}}</td><td>{{plain_draw}}</td><td>{{fine_draw}}</td><td>{{queries}}</td><td>{{lost}}</td></tr>
    {{/rows}}</tbody>
  </table></div>
  {{{chart}}}
  <p class="note"><span class="swatch" style="background: var(--stage)"></span>buffer<span class="swatch" style="background: var(--input)"></span>shadow map</p>
</section>
<section>
  <h2>What the buffer holds</h2>
  <p class="note">{{#legend}}<span class="swatch" style="background: rgb({{colour}})"></span>{{name}} {{/legend}}</p>
  <div class="plane">{{#pictures}}<figure><img src="{{data}}" alt="{{name}}: {{caption}}"><figcaption><strong>{{name}}</strong> {{caption}}</figcaption></figure>
  {{/pictures}}</div>
</section>
<section>
  <h2>Reproduce</h2>
  <pre tabindex="0">{{command}}</pre>
</section>
</main>
</body>
</html>
)html";

std::string data_uri(const std::string& png) {
  using namespace boost::archive::iterators;
  using Encode = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text = "data:image/png;base64,";
  text.append(Encode(png.begin()), Encode(png.end()));
  return text.append((3 - png.size() % 3) % 3, '=');
}

std::string rgb(const Colour& colour) {
  return fmt::format("{}, {}, {}", colour[0], colour[1], colour[2]);
}

mustache::data table(std::initializer_list<std::pair<const char*, std::string>> entries) {
  mustache::data object(mustache::data::type::object);
  for (const auto& [key, value] : entries) object.set(key, value);
  return object;
}

mustache::data legend() {
  mustache::data list(mustache::data::type::list);
  list << table({{"name", "wholly covered pixel"}, {"colour", rgb(kFullColour)}});
  list << table({{"name", "covered by lines"}, {"colour", rgb(kInsideColour)}});
  list << table({{"name", "lit part where something did not fit"}, {"colour", rgb(kOverflowColour)}});
  list << table({{"name", "stored line (a colour an object, modulo 4)"}, {"colour", rgb(kLineColours[0])}});
  list << table({{"name", "a line's part that bounds nothing"}, {"colour", rgb(kFaintColour)}});
  list << table({{"name", "the polygons"}, {"colour", rgb(kExactColour)}});
  return list;
}

std::string cycles(const Json& value) {
  return report::with_commas(static_cast<std::uint64_t>(value.get<double>()));
}

std::string pixels(const Json& value) {
  return value.get<double>() == 0 ? "0" : fmt::format("{:#.3g}", value.get<double>());
}

mustache::data row(const Json& point) {
  const Json &buffer = point.at("buffer"), &plain = point.at("plain_map"), &fine = point.at("fine_map");
  const Json& events = point.at("events");
  const auto memory = [](const Json& costs) {
    return report::bits(costs.at("memory_bits").get<std::uint64_t>());
  };
  const auto count = [&](const char* name) { return events.value(name, std::uint64_t{0}); };
  const double ratio = point.at("ratio").get<double>(), gain = point.at("gain").get<double>();
  return table(
      {{"widths", fmt::format("{}, {}", point.at("frac_bits").get<int>(), point.at("slope_bits").get<int>())},
       {"buffer", pixels(buffer.at("displacement"))},
       {"plain", pixels(plain.at("displacement"))},
       {"fine", pixels(fine.at("displacement"))},
       {"ratio", ratio > 0 ? report::fixed(ratio, 2) : "–"},
       {"gain", gain > 0 ? report::fixed(gain, 1) : "–"},
       {"buffer_memory", memory(buffer)},
       {"plain_memory", memory(plain)},
       {"fine_memory", memory(fine)},
       {"buffer_draw", cycles(buffer.at("draw_cycles"))},
       {"plain_draw", cycles(plain.at("draw_cycles"))},
       {"fine_draw", cycles(fine.at("draw_cycles"))},
       {"queries", cycles(buffer.at("query_cycles"))},
       {"lost", report::with_commas(count("SLB_CHAINS_DROPPED") + count("SLB_CHAINS_REDUCED"))}});
}

}  // namespace

std::string report_page(const Json& metrics, const std::vector<ReportPicture>& pictures) {
  const Json& points = metrics.at("points");
  mustache::data view(mustache::data::type::object);
  view.set("style", std::string(report::page_css()));
  view.set("lit", rgb(kLitColour));
  view.set("title", metrics.at("loops").get<std::string>());
  view.set("configuration", metrics.at("configuration").get<std::string>());
  view.set("command", metrics.at("command").get<std::string>());
  const bool measured = points.at(0).at("buffer").at("cycles_measured").get<bool>();
  view.set("cycles_note", std::string(measured ? "" : "; the buffer's in its documented steady state"));
  view.set("border", fmt::format("{:.1f}", points.at(0).at("border").get<double>()));
  view.set("queries", report::with_commas(points.at(0).at("samples").get<std::uint64_t>()));
  if (metrics.contains("verdict")) {
    view.set("verdict", table({{"class", metrics.at("passed").get<bool>() ? "good" : "bad"},
                               {"text", metrics.at("verdict").get<std::string>()}}));
  }
  mustache::data rows(mustache::data::type::list), figures(mustache::data::type::list);
  for (const Json& point : points) rows << row(point);
  for (const ReportPicture& picture : pictures)
    figures << table({{"name", picture.name}, {"caption", picture.caption}, {"data", data_uri(picture.png)}});
  view.set("rows", rows);
  view.set("pictures", figures);
  view.set("legend", legend());
  view.set("chart", error_chart(points));
  mustache::mustache page{std::string(kTemplate)};
  std::string html = page.is_valid() ? page.render(view) : "";
  if (!page.error_message().empty()) throw std::logic_error("report template: " + page.error_message());
  return html;
}

}  // namespace gnomon::slb
