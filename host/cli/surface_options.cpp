// SPDX-License-Identifier: Apache-2.0
#include "host/cli/surface_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gnomon::cli {

void SurfaceOptions::add_to(CLI::App& command, const std::string& output_help) {
  command.add_option("MODEL", model, "OBJ control cage, or scene file")->required();
  command.add_option("--res", res, "Voxels a side (the same as --set res=R)")->type_name("R");
  command.add_option("-o,--output", outputs, output_help)
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->required();
  command.add_flag("--json", json, "Print the figures as JSON");
  add_set_option(command, set);
}

Result<LoadedScene> SurfaceOptions::load(Context& context, std::vector<std::string> more) const {
  std::vector<std::string> flags = set;
  if (!res.empty()) flags.push_back("res=" + res);
  std::ranges::move(more, std::back_inserter(flags));
  return load_input(context, model, flags, {{"ground", "off", "default"}});
}

void SurfaceOptions::print_json(nlohmann::ordered_json figures) const {
  figures["files"] = nlohmann::ordered_json::array();
  for (const std::filesystem::path& output : outputs) figures["files"].push_back(output.string());
  fmt::print("{}\n", figures.dump(2));
}

void SurfaceOptions::print_outputs() const {
  for (const std::filesystem::path& output : outputs) fmt::print("{}\n", output.string());
}

}  // namespace gnomon::cli
