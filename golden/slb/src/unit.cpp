// SPDX-License-Identifier: Apache-2.0
// Commands, their order and their errors.
#include <gnomon/golden/slb/unit.hpp>
#include <stdexcept>

namespace gnomon::golden::slb {
namespace {

constexpr std::uint32_t kFirstEntryMask = 0xFFFFFF;

SlbConfig checked(const SlbConfig& config) {
  if (const auto error = check_items(config)) throw std::invalid_argument(*error);
  return config;
}

std::uint32_t depth_field(std::uint32_t arg, const SlbConfig& config) {
  return arg & config.no_depth();
}

}  // namespace

SlbUnit::SlbUnit(const SlbConfig& config) : model_(checked(config)) {}

bool SlbUnit::allowed(SlbOp op) const {
  using State = SlbModel::State;
  const State state = model_.state();
  switch (op) {
    case SlbOp::Clear:
    case SlbOp::BeginObject:
    case SlbOp::Query:
    case SlbOp::ReadEntries:
      return state == State::Idle;
    case SlbOp::Loop:
      return state == State::Object || state == State::Loop;
    case SlbOp::Fill:
      return state == State::Object;
    case SlbOp::Cover:
      return state == State::Filled;
    case SlbOp::EndObject:
      return state == State::Filled || (state == State::Object && !model_.has_loops());
  }
  return false;
}

SlbError SlbUnit::check(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) const {
  if (op < kFirstSlbOp || op > kLastSlbOp) return SlbError::UnknownOp;
  const auto known = static_cast<SlbOp>(op);
  const bool has_flag = known == SlbOp::BeginObject || known == SlbOp::Loop;
  if ((flags & ~(has_flag ? 1 : 0)) != 0) return SlbError::ReservedFlag;
  const bool has_items = known == SlbOp::Loop || known == SlbOp::Cover || known == SlbOp::Query;
  if (!has_items && count != 0) return SlbError::BadArgument;
  if (known == SlbOp::ReadEntries) {
    const std::uint64_t end = std::uint64_t{arg & kFirstEntryMask} + (arg >> 24) + 1;
    if (end > std::uint64_t{1} << (2 * model_.config().plane_log2)) return SlbError::BadArgument;
  }
  return allowed(known) ? SlbError::None : SlbError::BadSequence;
}

std::vector<Word> SlbUnit::read_entries(std::uint32_t arg) const {
  const SlbConfig& config = model_.config();
  const std::uint32_t first = arg & kFirstEntryMask, count = (arg >> 24) + 1;
  std::vector<Word> results;
  for (std::uint32_t index = first; index < first + count; ++index) {
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
  SlbOutcome outcome;
  outcome.error = check(op, flags, arg, items.size());
  if (outcome.error != SlbError::None) return outcome;
  const SlbConfig& config = model_.config();
  switch (static_cast<SlbOp>(op)) {
    case SlbOp::Clear:
      model_.clear();
      break;
    case SlbOp::BeginObject:
      model_.begin_object(static_cast<std::uint8_t>(arg >> 24), (flags & kBeginFlat) != 0,
                          depth_field(arg, config));
      break;
    case SlbOp::Loop:
      model_.enter_loop();
      for (const Word item : items) model_.vertex(decode_vertex(item, config));
      if ((flags & kLoopMore) == 0) model_.close_loop();
      break;
    case SlbOp::Fill:
      model_.fill();
      break;
    case SlbOp::Cover:
      for (const Word item : items) model_.cover(decode_cover(item, config), depth_field(arg, config));
      break;
    case SlbOp::EndObject:
      model_.end_object();
      break;
    case SlbOp::Query: {
      std::uint16_t index = 0;
      for (const Word item : items)
        outcome.results.push_back(
            encode(model_.query(decode_query(item, config), depth_field(arg, config)), index++));
      break;
    }
    case SlbOp::ReadEntries:
      outcome.results = read_entries(arg);
      break;
  }
  return outcome;
}

}  // namespace gnomon::golden::slb
