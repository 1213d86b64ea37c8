// SPDX-License-Identifier: Apache-2.0
// What each part does in a cycle is decided from what the cycles before left.
#include "slb_points.hpp"

namespace gnomon::golden::cycles {

SlbMoves SampleClock::cycle(const SlbRequest* item, bool updates, SlbMemory& memory, Ports& ports) {
  SlbMoves moves;
  memory.begin(ports);
  const bool goes = sample_ && memory.free();
  moves.waits = sample_ && !goes;
  if (goes) {
    memory.take(*sample_);
    sample_.reset();
  }
  moves.taken = item != nullptr && !sample_;
  if (moves.taken && updates) sample_ = *item;
  memory.serve(ports);
  return moves;
}

SlbMoves PointClock::cycle(const SlbRequest* item, SlbMemory& memory, Ports& ports) {
  constexpr unsigned kLast = 1U << 2U;
  SlbMoves moves;
  memory.begin(ports);
  const bool offers = (stages_ & kLast) != 0;
  moves.gives = offers && ports.room();
  moves.blocked = offers && !moves.gives;
  if (!moves.blocked) {
    const bool entry = memory.entry(ports.now());
    if (entry) memory.leave();
    stages_ = ((stages_ << 1U) & (2 * kLast - 1)) | (entry ? 1U : 0U);
  }
  const bool goes = point_ && memory.free();
  moves.waits = point_ && !goes;
  if (goes) {
    memory.take(*point_);
    point_.reset();
  }
  moves.taken = item != nullptr && !point_;
  if (moves.taken) point_ = *item;
  memory.serve(ports);
  return moves;
}

EntryClock::EntryClock(std::uint32_t first, std::uint32_t count, const slb::SlbConfig& config)
    : next_(first), to_ask_(count), to_give_(count), words_(1 + config.entry_words()) {}

/// An entry stays where it is until its last word is taken.
SlbMoves EntryClock::cycle(SlbMemory& memory, Ports& ports) {
  SlbMoves moves;
  memory.begin(ports);
  const bool there = memory.entry(ports.now());
  moves.gives = there && ports.room();
  moves.blocked = there && !moves.gives;
  if (moves.gives && ++given_ == words_) {
    given_ = 0;
    --to_give_;
    memory.leave();
  }
  const bool asks = to_ask_ != 0 && memory.free();
  moves.waits = to_ask_ != 0 && !asks;
  if (asks) {
    memory.take({.index = next_++, .kind = SlbRequest::Kind::Read});
    --to_ask_;
  }
  moves.steps = asks || moves.gives;
  memory.serve(ports);
  return moves;
}

}  // namespace gnomon::golden::cycles
