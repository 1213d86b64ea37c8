// SPDX-License-Identifier: Apache-2.0
// Verdicts as JUnit XML, which continuous integration reads.
#pragma once

#include <string>
#include <vector>

namespace gnomon::cli {

struct TestCase {
  std::string name;
  double seconds = 0;
  std::string failure;  ///< empty: passed
};

/// One test suite; characters that XML cannot hold are replaced.
std::string junit_xml(const std::string& suite, const std::vector<TestCase>& cases);

}  // namespace gnomon::cli
