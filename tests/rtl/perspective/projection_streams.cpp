// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/perspective/projection_streams.hpp"

#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/golden_engine.hpp>

#include "sim/counter_names.hpp"
#include "tests/rtl/topology/programs.hpp"
#include "tests/support/perspective_registers.hpp"
#include "tests/support/stimulus.hpp"

namespace gnomon::rtl_test {

using golden::HardwareConfig;
using golden::Header;
using golden::Op;
using golden::Word;

namespace {

void append_registers(std::vector<Word>& words, std::span<const std::int64_t> values, std::uint32_t first) {
  words.push_back(encode(Header{.op = static_cast<std::uint8_t>(Op::SetRegisters),
                                .count = static_cast<std::uint16_t>(values.size()),
                                .arg = first}));
  for (const std::int64_t value : values) words.push_back(static_cast<Word>(value));
}

/// A light of any kind; returns whether it is in perspective.
bool append_light(std::vector<Word>& words, const topology::ProjectionRegisters& directional,
                  stimulus::Random& random) {
  const HardwareConfig config = perspective_build();
  if (random.chance(20)) {
    append_registers(words, directional.matrix, 0);
    append_registers(words, std::array{directional.offset_factor}, 12);
    append_registers(words, std::array{std::int64_t{0}},
                     static_cast<std::uint32_t>(golden::Register::Projection));
    return false;
  }
  append_registers(words,
                   random.chance(15) ? stimulus::extreme_perspective_registers(config, 15, random)
                                     : stimulus::perspective_registers(config, random),
                   0);
  return true;
}

std::vector<Word> topology_words(std::uint64_t seed) {
  stimulus::Random random(seed);
  std::vector<Word> words;
  bool perspective = false;
  for (const topology::Command& command :
       topology::random_program(random, perspective_build().topology_config(), 30)) {
    if (command.sets_registers) {
      perspective = append_light(words, command.registers, random);
      continue;
    }
    const bool beams = command.op == golden::topology::TopologyOp::ResolveTopology;
    const auto clearance =
        static_cast<std::uint32_t>(random.chance(20) ? 0 : random.bits() >> random.between(40, 60));
    words.push_back(encode(Header{.op = static_cast<std::uint8_t>(command.op),
                                  .flags = command.flags,
                                  .count = static_cast<std::uint16_t>(command.items.size()),
                                  .arg = beams && perspective ? clearance : command.arg}));
    words.insert(words.end(), command.items.begin(), command.items.end());
  }
  words.push_back(encode(Header{.op = static_cast<std::uint8_t>(Op::Fence), .flags = 1}));
  return words;
}

}  // namespace

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
    cases.push_back({"topology mode, seed " + number, topology_words(seed), {}, {}});
  }
  const auto golden = golden::make_golden_engine(config);
  for (ProjectionCase& one : cases) {
    golden->reset();
    golden->submit(one.words);
    golden->drain(
        [&](std::span<const Word> some) { one.results.insert(one.results.end(), some.begin(), some.end()); });
    const auto counters = golden->counters();
    for (const auto& [index, name] : event_indices()) one.events.push_back(counters.events.at(name));
  }
  return cases;
}

}  // namespace gnomon::rtl_test
