// SPDX-License-Identifier: Apache-2.0
// `gnomon slb --report`: the error of the buffer by width, as a directory.
#pragma once

#include <filesystem>
#include <string>

#include "host/cli/slb_job.hpp"

namespace gnomon::cli {

/// Writes report.html, metrics.json and the pictures into `directory`, all of them or none. True if every
/// comparison holds. `command` is the line that makes the report again.
Result<bool> write_slb_report(Context& context, const SlbJob& job, const slb::Runner& runner,
                              const std::filesystem::path& directory, const std::string& command);

}  // namespace gnomon::cli
