// SPDX-License-Identifier: Apache-2.0
// Bins for results, commands and cycles.
#include "tests/sim/functional_bins.hpp"

#include <fmt/format.h>

#include <array>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>

namespace gnomon::sim::test {

namespace {

using golden::VoxelResult;
using golden::VoxelState;

/// The ways in which a voxel can be decided (docs/vpu.md, "Resolve").
std::string voxel_bin(const VoxelResult& result) {
  const std::string state = result.state == VoxelState::Lit ? "lit" : "shadow";
  if (result.behind) return state + ", behind the light";
  if (result.outside_cone) return state + ", outside the cone";
  if (result.facing_away)
    return state + (result.off_plane ? ", facing away, off the plane" : ", facing away");
  if (result.off_plane) return state + ", off the plane";
  if (!result.uncertain)
    return state + (result.nearest == 0xFFFFFF ? ", own entry empty" : ", nothing nearer");
  if (result.offset_empty) return state + ", uncertain, offset entry empty";
  if (result.beyond_max) return state + ", uncertain, beyond the largest margin";
  return state + (result.delta == 0 ? ", uncertain, offset point not behind" : ", uncertain, margin test");
}

constexpr std::array kVoxelBins{"shadow, behind the light",
                                "shadow, outside the cone",
                                "shadow, facing away",
                                "shadow, facing away, off the plane",
                                "lit, off the plane",
                                "lit, own entry empty",
                                "lit, nothing nearer",
                                "lit, uncertain, offset entry empty",
                                "shadow, uncertain, beyond the largest margin",
                                "lit, uncertain, offset point not behind",
                                "lit, uncertain, margin test",
                                "shadow, uncertain, margin test"};

/// Ops by name; everything the table does not have is "unknown".
std::string op_name(std::uint8_t op) {
  if (golden::slb::is_slb_op(op)) return "of the silhouette-line buffer";
  if (golden::topology::is_topology_op(op)) return "of topology mode";
  if (golden::frame::is_frame_op(op)) return "of the frame buffer";
  switch (static_cast<golden::Op>(op)) {
    case golden::Op::Nop:
      return "NOP";
    case golden::Op::SetRegisters:
      return "SET_REGISTERS";
    case golden::Op::ClearPlane:
      return "CLEAR_PLANE";
    case golden::Op::Fence:
      return "FENCE";
    case golden::Op::ReadPlane:
      return "READ_PLANE";
    case golden::Op::ProjectVoxels:
      return "PROJECT_VOXELS";
    case golden::Op::ResolveVoxels:
      return "RESOLVE_VOXELS";
  }
  return "unknown";
}

constexpr std::array kOps{"NOP",
                          "SET_REGISTERS",
                          "CLEAR_PLANE",
                          "FENCE",
                          "READ_PLANE",
                          "PROJECT_VOXELS",
                          "RESOLVE_VOXELS",
                          "of the silhouette-line buffer",
                          "of topology mode",
                          "of the frame buffer",
                          "unknown"};

/// The ways in which topology mode can decide a voxel (docs/vpu-topology.md, "Resolve").
std::string topology_bin(const golden::topology::TopologyResult& result) {
  const std::string state = result.shadow ? "shadow" : "lit";
  if (result.behind) return state + ", behind the light";
  if (result.outside_cone) return state + ", outside the cone";
  if (result.facing_away) return state + ", facing away";
  if (result.off_plane) return state + ", off the plane";
  if (!result.uncertain) return state + ", nothing nearer";
  if (result.fallback) return state + ", nodes were dropped";
  return state + (result.tested == 0 ? ", no quad tested" : result.hit ? ", hit" : ", no quad hit");
}

constexpr std::array kTopologyBins{
    "shadow, behind the light", "shadow, outside the cone",   "shadow, facing away", "lit, off the plane",
    "lit, nothing nearer",      "shadow, nodes were dropped", "lit, no quad tested", "shadow, hit",
    "lit, no quad hit"};

/// A word of the frame buffer's, by its number of states.
std::string states_bin(golden::Word word) {
  const std::size_t count = golden::frame::decode_states(word).size();
  return count == golden::frame::kStatesPerWord ? "a full word" : count == 16 ? "16 states" : "fewer states";
}

/// What a resolve command does with its states.
std::string keeping_bin(const golden::Header& header) {
  const std::string op =
      header.op == static_cast<std::uint8_t>(golden::Op::ResolveVoxels) ? "offset" : "topology";
  return "states of " + op + ((header.flags & golden::frame::kKeep) != 0 ? ", kept" : "") +
         ((header.flags & golden::frame::kQuiet) != 0 ? ", not told" : ", told");
}

bool resolves(std::uint8_t op) {
  return op == static_cast<std::uint8_t>(golden::Op::ResolveVoxels) ||
         op == static_cast<std::uint8_t>(golden::topology::TopologyOp::ResolveTopology);
}

/// What decided an answer (docs/slb.md, "Query").
std::string answer_bin(const golden::slb::QueryAnswer& answer) {
  if (answer.off_plane) return "off the plane";
  std::string bin = answer.by_full    ? (answer.by_lines ? "shadow by both" : "shadow by full depth")
                    : answer.by_lines ? "shadow by lines"
                                      : "lit";
  if (answer.has_fragment) bin += ", with lines";
  if (answer.overflow) bin += ", overflow";
  return bin;
}

constexpr std::array kAnswerBins{"off the plane",
                                 "lit",
                                 "lit, with lines",
                                 "lit, with lines, overflow",
                                 "lit, overflow",
                                 "shadow by full depth",
                                 "shadow by full depth, with lines",
                                 "shadow by full depth, with lines, overflow",
                                 "shadow by full depth, overflow",
                                 "shadow by lines, with lines",
                                 "shadow by lines, with lines, overflow",
                                 "shadow by both, with lines",
                                 "shadow by both, with lines, overflow"};
constexpr std::array<std::pair<std::uint32_t, const char*>, 6> kOtherSticky{
    {{golden::topology::kStickyListOverflow, "fence: list overflow"},
     {golden::topology::kStickyQuadOffPlane, "fence: quad off the plane"},
     {golden::topology::kStickyBehindLight, "fence: behind the light"},
     {golden::slb::kStickyLineOverflow, "fence: line overflow"},
     {golden::slb::kStickyObjectOverflow, "fence: object overflow"},
     {golden::slb::kStickyWindingSaturated, "fence: winding saturated"}}};

}  // namespace

FunctionalBins::FunctionalBins() {
  for (const char* bin : kVoxelBins) expect(fmt::format("voxel: {}", bin));
  for (const char* bin : kAnswerBins) expect(fmt::format("answer: {}", bin));
  for (const char* bin : kTopologyBins) expect(fmt::format("topology: {}", bin));
  for (const char* bin : {"a full word", "16 states", "fewer states"}) expect(fmt::format("frame: {}", bin));
  for (const char* op : {"offset", "topology"}) {
    for (const char* keeping : {", told", ", not told", ", kept, told", ", kept, not told"})
      expect(fmt::format("states of {}{}", op, keeping));
  }
  for (const auto& [bit, name] : kOtherSticky) expect(name);
  for (int error = 1; error <= 6; ++error) expect(fmt::format("error {}", error));
  for (int sticky = 0; sticky < 8; ++sticky) expect(fmt::format("fence: sticky {:03b}", sticky));
  for (const bool present : {false, true}) expect(fmt::format("plane entry: present {:d}", present));
  for (const char* from : kOps) {
    for (const char* to : kOps) expect(fmt::format("commands: {} then {}", from, to));
  }
  for (const char* length : {"0 items", "1 item", "more items"}) {
    for (const char* op : {"NOP", "SET_REGISTERS", "PROJECT_VOXELS", "RESOLVE_VOXELS"}) {
      expect(fmt::format("length: {} with {}", op, length));
    }
  }
}

void FunctionalBins::add_results(std::span<const golden::Word> results) {
  golden::ResultReader reader(results);
  while (const auto result = reader.next()) {
    const golden::Word word = result->word;
    if (static_cast<std::uint8_t>(golden::result_code(word)) == golden::slb::kAnswerCode) {
      count("answer: " + answer_bin(golden::slb::decode_answer(word)));
    }
    if (static_cast<std::uint8_t>(golden::result_code(word)) == golden::topology::kStateCode) {
      count("topology: " + topology_bin(golden::topology::decode_topology_result(word)));
    }
    if (static_cast<std::uint8_t>(golden::result_code(word)) == golden::frame::kStatesCode) {
      count("frame: " + states_bin(word));
    }
    switch (golden::result_code(word)) {
      case golden::ResultCode::VoxelState:
        count("voxel: " + voxel_bin(golden::decode_voxel_result(word)));
        break;
      case golden::ResultCode::Error:
        count(fmt::format("error {}", golden::decode_error_result(word).error));
        break;
      case golden::ResultCode::Fence:
        add_sticky(golden::decode_fence_result(word).sticky);
        break;
      case golden::ResultCode::PlaneEntry:
        count(fmt::format("plane entry: present {:d}", golden::decode_plane_entry_result(word).present));
        break;
    }
  }
}

void FunctionalBins::add_sticky(std::uint32_t sticky) {
  count(fmt::format("fence: sticky {:03b}", sticky & 7));
  for (const auto& [bit, name] : kOtherSticky) {
    if ((sticky & bit) != 0) count(name);
  }
}

void FunctionalBins::add_stream(std::span<const golden::Word> stream, const golden::HardwareConfig& config) {
  golden::CommandReader reader(stream);
  golden::CommandSequence sequence(config);
  std::string before;
  while (const auto command = reader.next()) {
    const bool sound = !sequence.next(command->header);
    const std::string op = op_name(command->header.op);
    if (!before.empty()) count(fmt::format("commands: {} then {}", before, op));
    before = op;
    const std::string length = fmt::format("length: {} with {}", op,
                                           command->header.count == 0   ? "0 items"
                                           : command->header.count == 1 ? "1 item"
                                                                        : "more items");
    if (counts_.contains(length) && sound) count(length);
    if (resolves(command->header.op) && sound) count(keeping_bin(command->header));
  }
}

void FunctionalBins::add_cycles(const golden::Counters& counters) {
  for (const auto& [name, cycles] : counters.cycles) counts_[name] += cycles;
}

}  // namespace gnomon::sim::test
