// SPDX-License-Identifier: Apache-2.0
// All parameters, as the main job takes them.
#include "host/cli/run_settings.hpp"

#include "host/cli/scene_input.hpp"
#include "host/cli/slb_settings.hpp"
#include "host/cli/vpu_settings.hpp"

namespace gnomon::cli {

pipeline::RunSettings run_settings(const config::Settings& settings) {
  pipeline::RunSettings run;
  run.res = static_cast<std::uint32_t>(settings.integer("res"));
  run.adjacency = adjacency_of(settings);
  run.technique = settings.word("technique");
  run.vpu = vpu_settings(settings);
  run.slb = slb_settings(settings);
  run.clock_mhz = settings.number("clock_mhz");
  run.image_width = static_cast<int>(settings.integer("image_width"));
  run.image_height = static_cast<int>(settings.integer("image_height"));
  run.threads = static_cast<unsigned>(settings.integer("threads"));
  return run;
}

}  // namespace gnomon::cli
