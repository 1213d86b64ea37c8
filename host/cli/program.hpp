// SPDX-License-Identifier: Apache-2.0
// The gnomon program: its subcommands, its exit statuses, its messages.
#pragma once

#include <string>
#include <vector>

namespace gnomon::cli {

/// Runs one command line (arguments without the program's name) and returns the exit status. Figures go to
/// stdout, everything else to stderr.
int run_program(const std::vector<std::string>& arguments);

}  // namespace gnomon::cli
