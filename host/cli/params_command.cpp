// SPDX-License-Identifier: Apache-2.0
// gnomon params: every parameter with its range, default and meaning.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/cli/command.hpp"
#include "host/config/parameter.hpp"

namespace gnomon::cli {
namespace {

nlohmann::ordered_json value_json(const config::Value& value) {
  return std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value);
}

nlohmann::ordered_json parameter_json(const config::Parameter& parameter) {
  static constexpr std::array<std::string_view, 5> kTypes{"integer", "number", "choice", "choices", "vector"};
  return {{"key", parameter.key},       {"type", kTypes.at(static_cast<std::size_t>(parameter.type))},
          {"range", parameter.range()}, {"default", value_json(parameter.preset)},
          {"unit", parameter.unit},     {"environment", parameter.environment()},
          {"help", parameter.help}};
}

void print_table() {
  fmt::print("{:<18}{:<14}{:<14}{}\n", "key", "default", "unit", "meaning; what it takes");
  for (const config::Parameter& parameter : config::parameters()) {
    fmt::print("{:<18}{:<14.12}{:<14}{}; {}\n", parameter.key, config::to_text(parameter.preset),
               parameter.unit, parameter.help, parameter.range());
  }
  fmt::print("\nSet with --set key=value, {}<KEY> in the environment, or [parameters] in a scene file.\n",
             config::kEnvironmentPrefix);
}

class ParamsCommand : public Command {
 public:
  CLI::App* add_to(CLI::App& program) override {
    CLI::App* command =
        program.add_subcommand("params", "List every parameter with its range, default and meaning");
    command->add_flag("--json", json_, "Print as JSON");
    command->footer("Example:\n  gnomon params --json");
    return command;
  }

  Result<int> run(Context&) override {
    if (json_) {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const config::Parameter& parameter : config::parameters())
        list.push_back(parameter_json(parameter));
      fmt::print("{}\n", list.dump(2));
    } else {
      print_table();
    }
    return kDone;
  }

 private:
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_params_command() {
  return std::make_unique<ParamsCommand>();
}

}  // namespace gnomon::cli
