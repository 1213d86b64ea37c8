// SPDX-License-Identifier: Apache-2.0
// OpenSubdiv prints warnings and errors on stdout unless it is told otherwise; figures go there, so it is
// told.
#pragma once

#include <string>
#include <vector>

namespace gnomon::surface {

/// While one of these lives, what OpenSubdiv reports in any thread is collected; afterwards it is dropped.
/// Scopes in different threads may overlap, then each message goes to all of them.
class OsdWarnings {
 public:
  OsdWarnings();
  OsdWarnings(const OsdWarnings&) = delete;
  OsdWarnings& operator=(const OsdWarnings&) = delete;
  ~OsdWarnings();

  /// The messages so far, leaving none.
  std::vector<std::string> take();
};

}  // namespace gnomon::surface
