// SPDX-License-Identifier: Apache-2.0
// A sweep's report: one page that loads nothing. What it shows: docs/sweep.md, "Report".
#pragma once

#include <string>
#include <vector>

#include "host/sweep/store.hpp"

namespace gnomon::sweep {

/// The whole page. Rows as the store gives them.
std::string sweep_page(const std::string& title, const std::vector<Row>& rows);

}  // namespace gnomon::sweep
