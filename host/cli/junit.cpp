// SPDX-License-Identifier: Apache-2.0
// Verdicts as JUnit XML.
#include "host/cli/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::cli {
namespace {

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&') {
      xml += "&amp;";
    } else if (c == '<') {
      xml += "&lt;";
    } else if (c == '>') {
      xml += "&gt;";
    } else if (c == '"') {
      xml += "&quot;";
    } else {
      xml += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return xml;
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<TestCase>& cases) {
  const auto failures =
      std::count_if(cases.begin(), cases.end(), [](const TestCase& c) { return !c.failure.empty(); });
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  xml += fmt::format("<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\">\n", escaped(suite), cases.size(),
                     failures);
  for (const TestCase& c : cases) {
    xml += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", escaped(suite),
                       escaped(c.name), c.seconds);
    xml += c.failure.empty()
               ? "/>\n"
               : fmt::format(">\n    <failure>{}</failure>\n  </testcase>\n", escaped(c.failure));
  }
  return xml + "</testsuite>\n";
}

}  // namespace gnomon::cli
