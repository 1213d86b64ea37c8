// SPDX-License-Identifier: Apache-2.0
// The report's plots as files for papers. What they show: docs/sweep.md, "Plots".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/sweep/store.hpp"

namespace gnomon::sweep {

struct Plot {
  std::string name;  ///< of the file, without an ending
  std::string svg;
};

/// Of each scene: its error against every cost that some point has, and against F, S and K where they vary.
std::vector<Plot> plots_of(const std::vector<Row>& rows);

/// Makes or replaces the folder's SVG files and, by rsvg-convert, their PNG files. Fails where the folder
/// cannot be written. False where there is no rsvg-convert: then there are no PNG files.
Result<bool> write_plots(const std::vector<Plot>& plots, const std::filesystem::path& folder);

}  // namespace gnomon::sweep
