// SPDX-License-Identifier: Apache-2.0
// The command table of docs/command-stream.md.
#include <gnomon/golden/slb/sequence.hpp>

namespace gnomon::golden::slb {
namespace {

bool takes_items(SlbOp op) {
  return op == SlbOp::Loop || op == SlbOp::Cover || op == SlbOp::Query;
}

}  // namespace

std::uint8_t known_flags(SlbOp op) {
  if (op == SlbOp::BeginObject) return kBeginFlat;
  if (op == SlbOp::Loop) return kLoopMore;
  return 0;
}

bool bad_argument(SlbOp op, std::uint32_t arg, std::size_t count, const SlbConfig& config) {
  if (!takes_items(op) && count != 0) return true;
  if (op != SlbOp::ReadEntries) return false;
  const EntryRange range = decode_entry_range(arg);
  return std::uint64_t{range.first} + range.count > std::uint64_t{1} << (2 * config.plane_log2);
}

std::uint32_t result_words(SlbOp op, std::uint32_t arg, std::size_t count, const SlbConfig& config) {
  if (op == SlbOp::Query) return static_cast<std::uint32_t>(count);
  if (op != SlbOp::ReadEntries) return 0;
  return decode_entry_range(arg).count * static_cast<std::uint32_t>(1 + config.entry_words());
}

bool SlbSequence::allows(SlbOp op) const {
  switch (op) {
    case SlbOp::Clear:
    case SlbOp::BeginObject:
    case SlbOp::Query:
    case SlbOp::ReadEntries:
      return state_ == State::Idle;
    case SlbOp::Loop:
      return state_ == State::Object || state_ == State::Loop;
    case SlbOp::Fill:
      return state_ == State::Object;
    case SlbOp::Cover:
      return state_ == State::Filled;
    case SlbOp::EndObject:
      return state_ == State::Filled || (state_ == State::Object && !has_loops_);
  }
  return false;
}

void SlbSequence::advance(SlbOp op, std::uint8_t flags) {
  switch (op) {
    case SlbOp::BeginObject:
      state_ = State::Object;
      has_loops_ = false;
      break;
    case SlbOp::Loop:
      state_ = (flags & kLoopMore) != 0 ? State::Loop : State::Object;
      has_loops_ = true;
      break;
    case SlbOp::Fill:
      state_ = State::Filled;
      break;
    case SlbOp::EndObject:
      state_ = State::Idle;
      break;
    case SlbOp::Clear:
    case SlbOp::Cover:
    case SlbOp::Query:
    case SlbOp::ReadEntries:
      break;
  }
}

}  // namespace gnomon::golden::slb
