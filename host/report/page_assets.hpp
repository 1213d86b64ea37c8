// SPDX-License-Identifier: Apache-2.0
// The files of page/, compiled in by cmake/embed_assets.cmake.
#pragma once

#include <string_view>

namespace gnomon::report {

std::string_view page_html();  ///< the Mustache template
std::string_view page_css();
std::string_view page_js();

}  // namespace gnomon::report
