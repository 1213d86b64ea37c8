// SPDX-License-Identifier: Apache-2.0
// The bits of the frame buffer's words.
#include <gnomon/golden/frame/codec.hpp>
#include <stdexcept>

namespace gnomon::golden::frame {
namespace {

constexpr int kCode = 56, kCount = 48;

std::uint32_t low(Word word, int width) {
  return static_cast<std::uint32_t>(word & ((Word{1} << width) - 1));
}

}  // namespace

std::uint8_t known_flags(FrameOp op) {
  return op == FrameOp::LookupFrame ? kBrick : 0;
}

bool bad_argument(FrameOp op, std::uint32_t arg, std::size_t count, const FrameConfig& config) {
  return op == FrameOp::ClearFrame ? count != 0 : decode_layer(arg) >= config.layers();
}

std::uint32_t result_words(FrameOp op, std::uint8_t flags, std::size_t count) {
  if (op == FrameOp::ClearFrame) return 0;
  const bool bricks = (flags & kBrick) != 0;
  return static_cast<std::uint32_t>(bricks ? count * kBrickWords
                                           : (count + kStatesPerWord - 1) / kStatesPerWord);
}

Cell decode_cell(Word item, const FrameConfig& config) {
  const int p = config.position_bits(), f = config.voxel_frac_bits;
  return {.x = low(item, p) >> f, .y = low(item >> p, p) >> f, .z = low(item >> (2 * p), p) >> f};
}

Word encode_cell(const Cell& cell, const FrameConfig& config) {
  const int p = config.position_bits(), f = config.voxel_frac_bits;
  return Word{cell.x} << f | Word{cell.y} << (p + f) | Word{cell.z} << (2 * p + f);
}

Word encode_states(std::span<const State> states) {
  if (states.empty() || states.size() > kStatesPerWord)
    throw std::invalid_argument("a word of states holds 1 to 24");
  Word word = Word{kStatesCode} << kCode | Word{states.size()} << kCount;
  for (std::size_t i = 0; i < states.size(); ++i) word |= Word{states[i] & 3u} << (2 * i);
  return word;
}

std::vector<State> decode_states(Word word) {
  const std::size_t count = word >> kCount & 0xFF;
  if (count > kStatesPerWord) throw std::invalid_argument("a word of states holds 24 at most");
  std::vector<State> states(count);
  for (std::size_t i = 0; i < count; ++i) states[i] = static_cast<State>(word >> (2 * i) & 3);
  return states;
}

std::string describe_states(Word word) {
  const std::size_t count = word >> kCount & 0xFF;
  std::string text = "FRAME_STATES count=" + std::to_string(count) + " states=";
  for (std::size_t i = 0; i < kStatesPerWord; ++i) text += static_cast<char>('0' + (word >> (2 * i) & 3));
  return text;
}

}  // namespace gnomon::golden::frame
