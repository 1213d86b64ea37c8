// SPDX-License-Identifier: Apache-2.0
// What is kept, and what a lookup answers.
#include <algorithm>
#include <gnomon/golden/frame/unit.hpp>
#include <stdexcept>

namespace gnomon::golden::frame {

std::vector<std::pair<std::string, std::uint64_t>> named(const FrameCounters& c) {
  return {{"FRAME_KEPT", c.kept},
          {"FRAME_OVERWRITTEN", c.overwritten},
          {"FRAME_LOOKUPS", c.lookups},
          {"FRAME_LOOKUPS_EMPTY", c.lookups_empty},
          {"FRAME_BRICKS", c.bricks}};
}

void FrameUnit::begin(FrameOp op, std::uint8_t flags, std::uint32_t arg, std::size_t count) {
  if (op == FrameOp::ClearFrame) return memory_.clear();
  whole_bricks_ = (flags & kBrick) != 0;
  layer_ = decode_layer(arg);
  items_left_ = count;
  pending_.clear();
}

std::vector<Word> FrameUnit::take(std::span<const Word> items) {
  if (items.size() > items_left_) throw std::logic_error("more items than the command has");
  std::vector<Word> results;
  for (const Word item : items) {
    --items_left_;
    const Cell cell = decode_cell(item, config_);
    if (whole_bricks_)
      read_brick(cell, results);
    else
      look_up(cell, results);
  }
  return results;
}

void FrameUnit::look_up(const Cell& cell, std::vector<Word>& results) {
  const State state = memory_.get(layer_, cell);
  ++counters_.lookups;
  counters_.lookups_empty += state == 0 ? 1U : 0U;
  pending_.push_back(state);
  if (pending_.size() < kStatesPerWord && items_left_ != 0) return;
  results.push_back(encode_states(pending_));
  pending_.clear();
}

void FrameUnit::read_brick(const Cell& cell, std::vector<Word>& results) {
  const Brick brick = memory_.brick(layer_, cell);
  ++counters_.bricks;
  std::array<State, kBrickStates> states;
  for (std::size_t i = 0; i < states.size(); ++i) states[i] = state_in(brick, i);
  std::span<const State> rest = states;
  while (!rest.empty()) {
    const auto part = rest.first(std::min(rest.size(), kStatesPerWord));
    results.push_back(encode_states(part));
    rest = rest.subspan(part.size());
  }
}

void FrameUnit::keep(std::uint32_t layer, std::span<const Word> items, std::span<const Word> results) {
  if (items.size() != results.size()) throw std::logic_error("a state word for each voxel");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const State before = memory_.put(layer, decode_cell(items[i], config_), state_of(results[i]));
    counters_.overwritten += before != 0 ? 1U : 0U;
  }
  counters_.kept += items.size();
}

}  // namespace gnomon::golden::frame
