// SPDX-License-Identifier: Apache-2.0
// What a subcommand is, and what it may use of the program around it.
#pragma once

#include <spdlog/logger.h>

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/cli/interruption.hpp"

namespace gnomon::cli {

/// Exit statuses of the program.
inline constexpr int kDone = 0;              ///< and all comparisons hold
inline constexpr int kComparisonFailed = 1;  ///< the report is written all the same
inline constexpr int kBadInput = 2;          ///< one line on stderr, nothing written
inline constexpr int kInternalFault = 3;
inline constexpr int kInterrupted = 130;  ///< as shells have it

/// The program around a subcommand.
struct Context {
  std::shared_ptr<spdlog::logger> log;    ///< to stderr
  bool show_progress = false;             ///< stderr is a terminal and nobody asked for quiet
  Interruption& interruption;             ///< Ctrl-C
  std::vector<std::string> command_line;  ///< as typed
};

/// One subcommand. Each lives in its own file, <name>_command.cpp.
class Command {
 public:
  virtual ~Command() = default;
  /// Adds itself with its options to `program`; their values end up in this object.
  virtual CLI::App* add_to(CLI::App& program) = 0;
  /// The exit status; errors are printed by the program, which then exits with kBadInput.
  virtual Result<int> run(Context& context) = 0;
};

std::unique_ptr<Command> make_area_command();
std::unique_ptr<Command> make_doctor_command();
std::unique_ptr<Command> make_mesh_command();
std::unique_ptr<Command> make_params_command();
std::unique_ptr<Command> make_run_command();
std::unique_ptr<Command> make_slb_command();
std::unique_ptr<Command> make_sweep_command();
std::unique_ptr<Command> make_verify_command();
std::unique_ptr<Command> make_voxelize_command();
std::unique_ptr<Command> make_wave_command();

}  // namespace gnomon::cli
