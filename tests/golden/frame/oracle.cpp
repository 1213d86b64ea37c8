// SPDX-License-Identifier: Apache-2.0
// The page in the plainest way.
#include "tests/golden/frame/oracle.hpp"

#include <algorithm>
#include <array>
#include <gnomon/golden/golden_engine.hpp>
#include <gnomon/golden/stream.hpp>

namespace gnomon::test {
namespace {

constexpr std::uint8_t kResolveVoxels = 0x11, kResolveTopology = 0x14, kClearFrame = 0x30, kLookup = 0x31;
using Place = std::array<std::uint64_t, 4>;  // layer, x, y, z

bool resolves(const golden::Header& header) {
  return header.op == kResolveVoxels || header.op == kResolveTopology;
}

class Oracle {
 public:
  Oracle(const HardwareConfig& config, std::span<const Word> states) : config_(config), states_(states) {
    for (const char* name :
         {"FRAME_KEPT", "FRAME_OVERWRITTEN", "FRAME_LOOKUPS", "FRAME_LOOKUPS_EMPTY", "FRAME_BRICKS"})
      out_.counters[name] = 0;
  }

  void take(const golden::Command& command) {
    const golden::Header& header = command.header;
    if (header.op == kClearFrame) cells_.clear();
    if (header.op == kLookup) header.flags == 1 ? bricks(command) : lookups(command);
    if (resolves(header)) resolve(command);
    if (header.op == 0x03) out_.results.push_back(next_plain());
  }

  FrameOracle finish() { return std::move(out_); }

 private:
  Word next_plain() { return states_[used_++]; }

  Place place(const golden::Command& command, Word item) const {
    const std::uint64_t positions = std::uint64_t{1} << config_.position_bits();
    const std::uint64_t fractions = std::uint64_t{1} << config_.voxel_frac_bits;
    const std::uint64_t x = item % positions, y = item / positions % positions,
                        z = item / positions / positions % positions;
    return {command.header.arg / 0x10000000, x / fractions, y / fractions, z / fractions};
  }

  std::uint64_t state(const Place& where) const {
    const auto found = cells_.find(where);
    return found == cells_.end() ? 0 : found->second;
  }

  void resolve(const golden::Command& command) {
    const bool keep = (command.header.flags & 0x40) != 0, quiet = (command.header.flags & 0x80) != 0;
    for (const Word item : command.items) {
      const Word result = next_plain();
      if (!quiet) out_.results.push_back(result);
      if (!keep) continue;
      const Place where = place(command, item);
      ++out_.counters["FRAME_KEPT"];
      if (state(where) != 0) ++out_.counters["FRAME_OVERWRITTEN"];
      cells_[where] = result / (Word{1} << 54) % 4;
    }
  }

  void lookups(const golden::Command& command) {
    std::vector<std::uint64_t> states;
    for (const Word item : command.items) {
      states.push_back(state(place(command, item)));
      ++out_.counters["FRAME_LOOKUPS"];
      if (states.back() == 0) ++out_.counters["FRAME_LOOKUPS_EMPTY"];
    }
    give(states);
  }

  void bricks(const golden::Command& command) {
    for (const Word item : command.items) {
      const Place at = place(command, item);
      std::vector<std::uint64_t> states;
      for (std::uint64_t z = 0; z < 4; ++z)
        for (std::uint64_t y = 0; y < 4; ++y)
          for (std::uint64_t x = 0; x < 4; ++x)
            states.push_back(state({at[0], at[1] / 4 * 4 + x, at[2] / 4 * 4 + y, at[3] / 4 * 4 + z}));
      give(states);
      ++out_.counters["FRAME_BRICKS"];
    }
  }

  void give(const std::vector<std::uint64_t>& states) {
    for (std::size_t first = 0; first < states.size(); first += 24) {
      const std::size_t count = std::min<std::size_t>(24, states.size() - first);
      Word word = 0;
      for (std::size_t i = count; i > 0; --i) word = word * 4 + states[first + i - 1];
      out_.results.push_back(Word{0x31} << 56 | Word{count} << 48 | word);
    }
  }

  HardwareConfig config_;
  std::span<const Word> states_;
  std::size_t used_ = 0;
  std::map<Place, std::uint64_t> cells_;
  FrameOracle out_;
};

}  // namespace

Answer answer(const HardwareConfig& config, std::span<const Word> words, std::size_t piece) {
  const auto engine = golden::make_golden_engine(config);
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t count = piece == 0 ? words.size() : std::min(piece, words.size() - at);
    engine->submit(words.subspan(at, count));
    at += count;
  }
  Answer all;
  engine->drain(
      [&](std::span<const Word> some) { all.results.insert(all.results.end(), some.begin(), some.end()); });
  all.events = engine->counters().events;
  return all;
}

FrameOracle frame_oracle(const HardwareConfig& config, std::span<const Word> stream) {
  HardwareConfig plain = config;
  plain.en_frame_buffer = false;
  std::vector<Word> without;
  golden::CommandReader reader(stream);
  while (const auto command = reader.next()) {
    golden::Header header = command->header;
    if (header.op == kClearFrame || header.op == kLookup) continue;
    if (resolves(header)) header.flags &= 0x3F;
    without.push_back(golden::encode(header));
    without.insert(without.end(), command->items.begin(), command->items.end());
  }
  const Answer states = answer(plain, without);
  Oracle oracle(config, states.results);
  golden::CommandReader again(stream);
  while (const auto command = again.next()) oracle.take(*command);
  return oracle.finish();
}

HardwareConfig frame_hardware(int voxel_bits) {
  HardwareConfig config;
  config.voxel_bits = voxel_bits;
  config.plane_log2 = 4;
  config.en_vpu_topology = true;
  config.nodes_log2 = 12;
  config.quads_log2 = 10;
  config.en_frame_buffer = true;
  config.frame_layers_log2 = 2;
  return config;
}

}  // namespace gnomon::test
