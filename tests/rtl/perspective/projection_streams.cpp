// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/perspective/projection_streams.hpp"

#include <gnomon/golden/golden_engine.hpp>

#include "sim/counter_names.hpp"
#include "tests/rtl/topology/program_stream.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::rtl_test {

using golden::HardwareConfig;

HardwareConfig perspective_build() {
  HardwareConfig config;
  config.voxel_bits = 5;
  config.voxel_frac_bits = 1;
  config.depth_bits = 16;
  config.plane_log2 = 5;
  config.en_perspective = true;
  config.en_vpu_topology = true;
  config.sub_bits = 3;
  config.span_log2 = 3;
  config.nodes_log2 = 9;
  config.quads_log2 = 7;
  return config;
}

std::vector<std::pair<unsigned, std::string>> event_indices() {
  std::vector<std::pair<unsigned, std::string>> indices;
  const auto add = [&](unsigned first, const auto& names) {
    for (unsigned i = 0; i < names.size(); ++i) indices.emplace_back(first + i, names[i]);
  };
  add(0, sim::kEventNames);
  add(sim::kFirstTopologyCounter, sim::kTopologyEventNames);
  add(sim::kFirstPerspectiveCounter, sim::kPerspectiveEventNames);
  return indices;
}

std::vector<ProjectionCase> projection_cases(int random_streams) {
  const HardwareConfig config = perspective_build();
  std::vector<ProjectionCase> cases;
  for (auto& stream : stimulus::directed_streams(config))
    cases.push_back({std::move(stream.name), std::move(stream.words), {}, {}});
  for (int i = 1; i <= random_streams; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const std::string number = std::to_string(seed);
    cases.push_back({"offset mode, seed " + number, stimulus::random_stream(config, {.seed = seed}), {}, {}});
    cases.push_back(
        {"topology mode, seed " + number, topology::program_stream(config, {.seed = seed}), {}, {}});
  }
  const auto golden = golden::make_golden_engine(config);
  for (ProjectionCase& one : cases) {
    golden->reset();
    golden->submit(one.words);
    golden->drain([&](std::span<const golden::Word> some) {
      one.results.insert(one.results.end(), some.begin(), some.end());
    });
    const auto counters = golden->counters();
    for (const auto& [index, name] : event_indices()) one.events.push_back(counters.events.at(name));
  }
  return cases;
}

}  // namespace gnomon::rtl_test
