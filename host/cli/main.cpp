// SPDX-License-Identifier: Apache-2.0
// Entry of the gnomon program.
#include "host/cli/program.hpp"

int main(int argc, char** argv) {
  return gnomon::cli::run_program({argv + 1, argv + argc});
}
