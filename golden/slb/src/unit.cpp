// SPDX-License-Identifier: Apache-2.0
// Commands, their order and their errors.
#include <gnomon/golden/slb/unit.hpp>
#include <stdexcept>

namespace gnomon::golden::slb {
namespace {

SlbConfig checked(const SlbConfig& config) {
  if (const auto error = check_items(config)) throw std::invalid_argument(*error);
  return config;
}

}  // namespace

SlbUnit::SlbUnit(const SlbConfig& config) : model_(checked(config)) {}

SlbError SlbUnit::check(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) const {
  if (!is_slb_op(op)) return SlbError::UnknownOp;
  const auto known = static_cast<SlbOp>(op);
  if ((flags & ~known_flags(known)) != 0) return SlbError::ReservedFlag;
  if (bad_argument(known, arg, count, model_.config())) return SlbError::BadArgument;
  return sequence_.allows(known) ? SlbError::None : SlbError::BadSequence;
}

std::vector<Word> SlbUnit::read_entries(std::uint32_t arg) const {
  const SlbConfig& config = model_.config();
  const EntryRange range = decode_entry_range(arg);
  std::vector<Word> results;
  for (std::uint32_t index = range.first; index < range.first + range.count; ++index) {
    const auto column = static_cast<int>(index & static_cast<std::uint32_t>(config.side() - 1));
    const auto row = static_cast<int>(index >> config.plane_log2);
    const std::vector<Word> raw = pack(model_.entry(column, row), config);
    results.push_back(encode(EntryHeader{index, static_cast<std::uint8_t>(raw.size())}));
    results.insert(results.end(), raw.begin(), raw.end());
  }
  return results;
}

SlbOutcome SlbUnit::execute(std::uint8_t op, std::uint8_t flags, std::uint32_t arg,
                            std::span<const Word> items) {
  SlbOutcome outcome = begin(op, flags, arg, items.size());
  if (outcome.error != SlbError::None) return outcome;
  const std::vector<Word> results = take(items);
  outcome.results.insert(outcome.results.end(), results.begin(), results.end());
  return outcome;
}

SlbOutcome SlbUnit::begin(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) {
  if (const SlbError error = check(op, flags, arg, count); error != SlbError::None) return {error, {}};
  op_ = static_cast<SlbOp>(op);
  sequence_.advance(op_, flags);
  more_ = (flags & kLoopMore) != 0;
  depth_ = arg & model_.config().no_depth();
  items_left_ = count;
  index_ = 0;
  switch (op_) {
    case SlbOp::Clear:
      model_.clear();
      break;
    case SlbOp::BeginObject:
      model_.begin_object(static_cast<std::uint8_t>(arg >> 24), (flags & kBeginFlat) != 0, depth_);
      break;
    case SlbOp::Loop:
      model_.enter_loop();
      close_loop_if_complete();
      break;
    case SlbOp::Fill:
      model_.fill();
      break;
    case SlbOp::EndObject:
      model_.end_object();
      break;
    case SlbOp::ReadEntries:
      return {SlbError::None, read_entries(arg)};
    case SlbOp::Cover:
    case SlbOp::Query:
      break;  // the items do the work
  }
  return {};
}

std::vector<Word> SlbUnit::take(std::span<const Word> items) {
  if (items.empty()) return {};
  if (items.size() > items_left_) throw std::logic_error("more items than the command has");
  items_left_ -= items.size();
  const SlbConfig& config = model_.config();
  std::vector<Word> results;
  switch (op_) {
    case SlbOp::Loop:
      for (const Word item : items) model_.vertex(decode_vertex(item, config));
      close_loop_if_complete();
      break;
    case SlbOp::Cover:
      for (const Word item : items) model_.cover(decode_cover(item, config), depth_);
      break;
    case SlbOp::Query:
      results.reserve(items.size());
      for (const Word item : items)
        results.push_back(encode(model_.query(decode_query(item, config), depth_), index_++));
      break;
    default:
      break;  // no other command has items
  }
  return results;
}

void SlbUnit::close_loop_if_complete() {
  if (items_left_ == 0 && !more_) model_.close_loop();
}

}  // namespace gnomon::golden::slb
