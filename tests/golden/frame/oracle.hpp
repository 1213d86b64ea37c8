// SPDX-License-Identifier: Apache-2.0
// docs/frame-buffer.md once more, from the result words of hardware without a frame buffer: states in a map,
// fields by division instead of shifts.
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gnomon::test {

using golden::HardwareConfig;
using golden::Word;

/// What an engine with `config`, which has a frame buffer, must answer to a stream of sound commands, and the
/// frame buffer's counters. Result words of the resolve commands come from golden without a frame buffer.
struct FrameOracle {
  std::vector<Word> results;
  std::map<std::string, std::uint64_t> counters;
};
FrameOracle frame_oracle(const HardwareConfig& config, std::span<const Word> stream);

/// Everything `config` answers to `words`, submitted in pieces of `piece` words (0: all at once).
struct Answer {
  std::vector<Word> results;
  std::map<std::string, std::uint64_t> events;
};
Answer answer(const HardwareConfig& config, std::span<const Word> words, std::size_t piece = 0);

/// A grid of 16 or 32 a side with a plane of 16 x 16, both modes and 4 layers.
HardwareConfig frame_hardware(int voxel_bits);

}  // namespace gnomon::test
