// SPDX-License-Identifier: Apache-2.0
// report.html stands alone, escapes what it is given, and says what must be said.
#include "host/report/page.hpp"

#include <gmock/gmock.h>

#include <regex>

#include "host/report/metrics_json.hpp"
#include "tests/host/report/sample_record.hpp"

namespace gnomon::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_of(const RunRecord& record) {
  return report_page(metrics_json(record), {"reference!", {{"", "image", "error bytes"}}});
}

/// What the page would load: targets of src, href and url(), besides links within the page.
std::vector<std::string> outside_references(const std::string& html) {
  static const std::regex kReference(
      R"re((?:\bsrc|\bhref|\bsrcset|\baction|\bdata)\s*=\s*"([^"]*)"|url\(([^)]*)\)|@import\s+([^;]*))re");
  std::vector<std::string> found;
  for (std::sregex_iterator at(html.begin(), html.end(), kReference), end; at != end; ++at) {
    const std::string target = (*at)[1].str() + (*at)[2].str() + (*at)[3].str();
    if (!target.starts_with("#") && !target.starts_with("data:")) found.push_back(target);
  }
  return found;
}

TEST(Page, LoadsNothing) {
  const std::string html = page_of(sample_record());
  EXPECT_THAT(outside_references(html), testing::IsEmpty());
  EXPECT_THAT(html, Not(HasSubstr("http://")));
  EXPECT_THAT(html, Not(HasSubstr("https://")));
  EXPECT_THAT(html, HasSubstr("Content-Security-Policy"));
  EXPECT_THAT(html, Not(HasSubstr(" style=\""))) << "a strict policy refuses style attributes";
  EXPECT_THAT(html, Not(testing::ContainsRegex(" on[a-z]+=\""))) << "and event handlers";
}

TEST(Page, TheCheckForReferencesFindsThem) {
  EXPECT_THAT(outside_references(R"(<img src="data:x"><a href="#a"><script src="x.js">)"),
              testing::ElementsAre("x.js"));
  EXPECT_THAT(outside_references("a{background:url(//cdn/x)}"), testing::ElementsAre("//cdn/x"));
}

TEST(Page, PicturesAreInline) {
  const std::string html = page_of(sample_record());
  EXPECT_THAT(html, HasSubstr("\"data:image/png;base64,aW1hZ2U=\""));
  EXPECT_THAT(html, HasSubstr("\"data:image/png;base64,cmVmZXJlbmNlIQ==\""));
  EXPECT_THAT(html, HasSubstr("\"data:image/png;base64,ZXJyb3IgYnl0ZXM=\""));
}

TEST(Page, TheSystemEngineHasASectionOfItsOwn) {
  EXPECT_THAT(page_of(sample_record()), Not(HasSubstr("id=\"system\"")));
  const std::string html = page_of(system_record());
  EXPECT_THAT(html, HasSubstr("id=\"system\""));
  EXPECT_THAT(html, HasSubstr("firmware &lt;0&gt;"));
  EXPECT_THAT(html, HasSubstr("CACHE_PLANE_MISSES"));
  EXPECT_THAT(html, HasSubstr("500,000 cycles from power-up"));
}

/// 233 of 173,600 in fixed point, of all receivers.
TEST(Page, SteadyVoxelsStandBesideUnambiguousOnes) {
  const std::string html = page_of(sample_record());
  EXPECT_THAT(html, HasSubstr("<td data-label=\"mislabelled, unambiguous\">250<small>"));
  EXPECT_THAT(html, HasSubstr("<td data-label=\"mislabelled, steady\">233<small>0.134 %</small></td>"));
  EXPECT_THAT(html, HasSubstr("0.134 % of steady ones")) << "among the key figures";
  EXPECT_THAT(html, HasSubstr("<dt>steady</dt>"));
  const std::string techniques =
      report_page(metrics_json(std::vector<RunRecord>{sample_record(), topology_record()}),
                  {"reference", {{"voxel-offset", "a", "b"}, {"voxel-topology", "c", "d"}}});
  EXPECT_THAT(techniques, HasSubstr("<th scope=\"row\">mislabelled, steady</th><td>233 (0.134 %)</td>"));
}

TEST(Page, ATechniqueWithoutAFormInDoubleHasNoSuchLine) {
  RunRecord record = sample_record();
  EXPECT_THAT(page_of(record), HasSubstr("Quantisation error:"));
  record.errors.in_double.reset();
  EXPECT_THAT(page_of(record), Not(HasSubstr("Quantisation error:")));
  EXPECT_THAT(page_of(record), Not(HasSubstr("no rounding to speak of")));
  EXPECT_TRUE(metrics_json(record)["errors"]["double"].is_null());
}

TEST(Page, TheSilhouetteLineBufferIsShownBesideShadowMaps) {
  const std::string html =
      report_page(metrics_json(slb_record()), {"reference!", {{"", "image", "error bytes", "lines"}}});
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,bGluZXM="));
  EXPECT_THAT(html, HasSubstr("shadow map 256²"));
  EXPECT_THAT(html, HasSubstr("shadow map 32768²"));
  EXPECT_THAT(html, HasSubstr("FRAGS_PER_PIXEL 2"));
  EXPECT_THAT(html, HasSubstr("pixels with 2 fragments"));
  EXPECT_THAT(html, Not(HasSubstr("Projection plane")));
  EXPECT_THAT(page_of(sample_record()), Not(HasSubstr("Silhouette-line buffer")));
}

TEST(Page, TopologyModeShowsItsLists) {
  const std::string html = page_of(topology_record());
  EXPECT_THAT(html, HasSubstr("Lists of quads"));
  EXPECT_THAT(html, HasSubstr("9.00, 118"));
  EXPECT_THAT(html, HasSubstr("SUB_BITS 4"));
}

TEST(Page, LightsAndTheirViewsHaveTheirOwnTable) {
  const std::string html = page_of(lights_record());
  EXPECT_THAT(html, HasSubstr("spot at (0, 4, 1), shining (0, -1, 0), 40° wide"));
  EXPECT_THAT(html, HasSubstr("15,000"));
  EXPECT_THAT(html, HasSubstr("22.25")) << "voxels on an entry hit";
  EXPECT_THAT(page_of(sample_record()), Not(HasSubstr("id=\"lights\"")));
}

TEST(Page, SeveralTechniquesStandSideBySide) {
  std::vector<RunRecord> records{sample_record(), topology_record(), slb_record()};
  const Pictures pictures{"reference",
                          {{"voxel-offset", "a", "b"}, {"voxel-topology", "c", "d"}, {"slb", "e", "f"}}};
  const std::string html = report_page(metrics_json(records), pictures);
  EXPECT_THAT(html, HasSubstr("Techniques side by side"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"col\">voxel-offset</th><th scope=\"col\">voxel-topology</th>"));
  EXPECT_THAT(html, HasSubstr("id=\"picture-2-error\""));
  EXPECT_THAT(html, HasSubstr("class=\"verdict good\""));
  records[1].compare.differing = 3;
  EXPECT_THAT(report_page(metrics_json(records), pictures), HasSubstr("class=\"verdict bad\""))
      << "a failure of any technique shows at the top";
  EXPECT_THAT(page_of(sample_record()), Not(HasSubstr("side by side")));
}

TEST(Page, EverythingGivenIsEscaped) {
  RunRecord record = failing_record();
  const std::string evil = "<script>alert('x')</script>&\"";
  record.scene_name = record.scene_source = record.started = record.engine = record.technique = evil;
  record.command_line = {evil};
  record.versions = {{evil, evil}};
  record.parameters = {{evil, evil, evil, evil, evil}};
  record.objects[0].name = evil;
  record.warnings = {evil};
  record.registers[0].name = evil;
  record.cycles[0].pass = evil;
  record.stages[0].name = evil;
  record.compare.text = evil;
  record.compare.first["command"] = record.compare.first["item"] = evil;
  const std::string html = page_of(record);
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("alert('x')")));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(&apos;x&apos;)&lt;/script&gt;&amp;&quot;"));
}

TEST(Page, SaysThatAllWordsAgree) {
  const std::string html = page_of(sample_record());
  EXPECT_THAT(html, HasSubstr("217,001 words compared, 0 differ"));
  EXPECT_THAT(html, HasSubstr("class=\"verdict good\""));
  EXPECT_THAT(html, Not(HasSubstr("class=\"verdict bad\"")));
}

TEST(Page, ShowsTheFirstDifference) {
  const std::string html = page_of(failing_record());
  EXPECT_THAT(html, HasSubstr("class=\"verdict bad\""));
  EXPECT_THAT(html, Not(HasSubstr("class=\"verdict good\"")));
  EXPECT_THAT(html, HasSubstr("217,001 words compared, 3 differ"));
  EXPECT_THAT(html, HasSubstr("First difference: result word 41, cycle 4,711"));
  EXPECT_THAT(html, HasSubstr("1140000000000000 VOXEL_STATE lit"));
  EXPECT_THAT(html, HasSubstr("1180000000000000 VOXEL_STATE shadow"));
  EXPECT_THAT(html, HasSubstr("3 differ &lt;here&gt;"));
}

TEST(Page, GoldenAloneClaimsNoComparisonAndNoCycles) {
  const std::string html = page_of(golden_record());
  EXPECT_THAT(html, HasSubstr("class=\"verdict none\""));
  EXPECT_THAT(html, Not(HasSubstr("class=\"verdict good\"")));
  EXPECT_THAT(html, HasSubstr("not simulated"));
}

TEST(Page, PredictedCyclesStandBesideThoseTaken) {
  RunRecord record = sample_record();
  EXPECT_THAT(page_of(record), Not(HasSubstr("cycle model")));
  record.predicted_cycles = {{"cycles.IDLE.IDLE", 0},
                             {"cycles.CLEAR.BUSY", 4096},
                             {"cycles.PROJECT.BUSY", 217004},
                             {"cycles.PROJECT.HAZARD", 133},
                             {"cycles.RESOLVE.BUSY", 217000}};
  const std::string html = page_of(record);
  EXPECT_THAT(html, HasSubstr("438,233 cycles, 1,936 off"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"col\">predicted</th><th scope=\"col\">off by</th>"));
  EXPECT_THAT(html, HasSubstr("<td>217,137</td><td>+3</td>"));
  EXPECT_THAT(html, HasSubstr("<td>217,000</td><td>−1,933</td>"));
  EXPECT_THAT(html, HasSubstr("<td>4,096</td><td>0</td>"));
  EXPECT_THAT(html, HasSubstr("<td>438,233</td><td>1,936</td>"));
}

TEST(Page, GoldenAloneShowsWhatIsPredictedAndSaysSo) {
  RunRecord record = golden_record();
  record.predicted_cycles = {{"cycles.PROJECT.BUSY", 217004}, {"cycles.READ.BUSY", 1000}};
  const std::string html = page_of(record);
  EXPECT_THAT(html, HasSubstr("217,004 predicted"));
  EXPECT_THAT(html, HasSubstr("Predicted by the cycle model from the command stream, not simulated"));
  EXPECT_THAT(html, Not(HasSubstr("off by")));
}

TEST(Page, EveryErrorStandsNextToWhatItCosts) {
  const std::string html = page_of(sample_record());
  const std::size_t table = html.find("<table class=\"cards\">");
  const std::string rows = html.substr(table, html.find("</table>", table) - table);
  for (const char* figure : {"fixed point", "double", "exact", "440,241", "3.52 ms", "110 ms rtl", "1.20 s",
                             "2.10 Mbit", "0.1470"}) {
    EXPECT_THAT(rows, HasSubstr(figure));
  }
}

TEST(Page, MissingKeysAreNotPassedOver) {
  auto metrics = metrics_json(sample_record());
  metrics.erase("memory");
  EXPECT_THROW(report_page(metrics, {}), std::exception);
}

}  // namespace
}  // namespace gnomon::report
