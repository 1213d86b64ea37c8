// SPDX-License-Identifier: Apache-2.0
// What this program was built with.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gnomon::cli {

/// Tool or library, version; the program itself first.
std::vector<std::pair<std::string, std::string>> versions();

/// One line each.
std::string versions_text();

}  // namespace gnomon::cli
