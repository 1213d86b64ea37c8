// SPDX-License-Identifier: Apache-2.0
// Runs a topology plan on the golden engine, for the tests and figures of this folder.
#pragma once

#include <gnomon/golden/golden_engine.hpp>
#include <map>
#include <string>

#include "host/plan/topology_plan.hpp"

namespace gnomon::test {

struct TopologyRun {
  std::vector<golden::topology::TopologyResult> results;
  std::map<std::string, std::uint64_t> events;
  std::uint32_t sticky = 0;
};

inline TopologyRun run_topology(const plan::TopologyPlan& plan, const voxel::VoxelSet& voxels,
                                const std::vector<bool>& two_sided) {
  const auto engine = golden::make_golden_engine(plan.vpu.config);
  engine->submit(plan::topology_stream(plan, voxels, two_sided));
  std::vector<golden::Word> words;
  engine->drain(
      [&](std::span<const golden::Word> part) { words.insert(words.end(), part.begin(), part.end()); });
  return {plan::topology_results(words, plan.items.size()).value(), engine->counters().events,
          golden::decode_fence_result(words.back()).sticky};
}

}  // namespace gnomon::test
