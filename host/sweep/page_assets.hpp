// SPDX-License-Identifier: Apache-2.0
// The files of page/, compiled in by cmake/embed_assets.cmake.
#pragma once

#include <string_view>

namespace gnomon::sweep {

std::string_view page_html();  ///< the Mustache template
std::string_view page_css();   ///< besides the run report's
std::string_view page_js();
std::string_view page_uPlot_iife_min_js();  // NOLINT(readability-identifier-naming): the file's name
std::string_view page_uPlot_min_css();      // NOLINT(readability-identifier-naming): the file's name

}  // namespace gnomon::sweep
