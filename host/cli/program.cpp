// SPDX-License-Identifier: Apache-2.0
// The gnomon program.
#include "host/cli/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>

#include "host/cli/command.hpp"
#include "host/cli/versions.hpp"
#include "host/config/nearest.hpp"

namespace gnomon::cli {
namespace {

std::vector<std::unique_ptr<Command>> all_commands() {
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(make_run_command());
  commands.push_back(make_verify_command());
  commands.push_back(make_voxelize_command());
  commands.push_back(make_mesh_command());
  commands.push_back(make_slb_command());
  commands.push_back(make_sweep_command());
  commands.push_back(make_area_command());
  commands.push_back(make_wave_command());
  commands.push_back(make_params_command());
  commands.push_back(make_doctor_command());
  return commands;
}

/// One line on stderr. Messages that say where ("scene.toml:7: error: ...") stand for themselves.
void print_error(std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const bool placed = message.find(": error: ") != std::string::npos;
  fmt::print(stderr, "{}{}\n", placed ? "" : "gnomon: error: ", message);
}

std::shared_ptr<spdlog::logger> make_log(bool quiet, int verbose) {
  const char* no_color = std::getenv("NO_COLOR");
  const bool plain = no_color != nullptr && *no_color != '\0';
  auto sink = std::make_shared<spdlog::sinks::stderr_color_sink_st>(plain ? spdlog::color_mode::never
                                                                          : spdlog::color_mode::automatic);
  auto log = std::make_shared<spdlog::logger>("gnomon", sink);
  log->set_pattern("gnomon: %^%l%$: %v");
  log->set_level(quiet ? spdlog::level::err : verbose > 0 ? spdlog::level::debug : spdlog::level::info);
  return log;
}

/// The program as CLI11 sees it.
class Program {
 public:
  Program()
      : app_("Shadow-generation hardware, simulated cycle by cycle and checked word by word.", "gnomon") {
    app_.set_version_flag("--version", versions_text(),
                          "Show the versions of this program and of what it was built with");
    app_.add_flag("-q,--quiet", quiet_, "Errors only");
    app_.add_flag("-v,--verbose", verbose_, "Say more");
    app_.fallthrough();
    app_.require_subcommand(1);
    app_.footer(
        "Exit status: 0 done and all comparisons hold, 1 a comparison failed, 2 bad usage or input, 3 "
        "internal fault.\n\n"
        "Example:\n  gnomon run cup.obj -o out/cup");
    for (std::unique_ptr<Command>& command : commands_) entries_.push_back(command->add_to(app_));
  }

  int run(const std::vector<std::string>& arguments) {
    if (Result<void> known = check_command_name(arguments); !known) return refuse(known.error().message);
    try {
      // CLI11 takes them last first.
      app_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::Success& help) {
      app_.exit(help);
      return kDone;
    } catch (const CLI::ParseError& error) {
      return refuse(std::string(error.what()) + hint(arguments));
    }
    return run_chosen(arguments);
  }

 private:
  static int refuse(const std::string& message) {
    print_error(message);
    return kBadInput;
  }

  /// CLI11 would complain about every word that follows.
  Result<void> check_command_name(const std::vector<std::string>& arguments) const {
    std::vector<std::string> names;
    for (const CLI::App* entry : entries_) names.push_back(entry->get_name());
    const auto first = std::find_if(arguments.begin(), arguments.end(),
                                    [](const std::string& a) { return !a.starts_with('-'); });
    if (first == arguments.end()) {
      if (!arguments.empty()) return {};
      return fail(
          fmt::format("no command given, expected one of {}; see gnomon --help", fmt::join(names, ", ")));
    }
    if (std::find(names.begin(), names.end(), *first) != names.end()) return {};
    const std::vector<std::string_view> views(names.begin(), names.end());
    return fail(fmt::format("unknown command '{}', {}", *first, config::suggestion(*first, views)));
  }

  /// What somebody may have meant by an option that does not exist.
  std::string hint(const std::vector<std::string>& arguments) const {
    std::vector<const CLI::App*> apps{&app_};
    for (const CLI::App* entry : entries_) {
      if (std::find(arguments.begin(), arguments.end(), entry->get_name()) != arguments.end())
        apps.push_back(entry);
    }
    std::vector<std::string> known;
    for (const CLI::App* app : apps) {
      for (const CLI::Option* option : app->get_options()) {
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
      }
    }
    const std::vector<std::string_view> views(known.begin(), known.end());
    for (const std::string& argument : arguments) {
      const std::string name = argument.substr(0, argument.find('='));
      if (!name.starts_with("--") || std::find(known.begin(), known.end(), name) != known.end()) continue;
      return fmt::format("; unknown option '{}', {}", name, config::suggestion(name, views));
    }
    return fmt::format("; see gnomon {}--help", apps.size() == 1 ? "" : apps.back()->get_name() + " ");
  }

  int run_chosen(const std::vector<std::string>& arguments) {
    Interruption interruption;
    Context context{
        make_log(quiet_, verbose_), isatty(STDERR_FILENO) != 0 && !quiet_, interruption, {"gnomon"}};
    context.command_line.insert(context.command_line.end(), arguments.begin(), arguments.end());
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      if (!entries_[i]->parsed()) continue;
      const Result<int> status = commands_[i]->run(context);
      if (status) return *status;
      if (interruption.requested()) throw Interrupted();
      return refuse(status.error().message);
    }
    throw std::logic_error("a subcommand was parsed but not found");
  }

  CLI::App app_;
  bool quiet_ = false;
  int verbose_ = 0;
  std::vector<std::unique_ptr<Command>> commands_ = all_commands();
  std::vector<CLI::App*> entries_;
};

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
  try {
    return Program().run(arguments);
  } catch (const Interrupted&) {
    fmt::print(stderr, "gnomon: interrupted, nothing was written\n");
    return kInterrupted;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "gnomon: internal fault: {}\n", fault.what());
    return kInternalFault;
  }
}

}  // namespace gnomon::cli
