// SPDX-License-Identifier: Apache-2.0
// Executes commands, with their errors: what the hardware answers (docs/command-stream.md).
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/sequence.hpp>
#include <span>
#include <vector>

namespace gnomon::golden::slb {

/// Error codes of the unit; 0 is none.
enum class SlbError : std::uint8_t {
  None = 0,
  UnknownOp = 1,
  BadArgument = 4,
  ReservedFlag = 5,
  BadSequence = 6
};

/// What one command came to.
struct SlbOutcome {
  SlbError error = SlbError::None;
  std::vector<Word> results;  ///< empty if in error
};

class SlbUnit {
 public:
  /// Throws std::invalid_argument unless config.check() and check_items(config) pass.
  explicit SlbUnit(const SlbConfig& config);

  /// A command with all its items. In error it has no effect.
  SlbOutcome execute(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::span<const Word> items);

  /// The same in pieces: a header, with the results that need no items. In error it has no effect, and its
  /// items must be kept back.
  SlbOutcome begin(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count);
  /// The next items of the command begun, `count` in all; their results.
  std::vector<Word> take(std::span<const Word> items);

  SlbModel& model() { return model_; }
  const SlbModel& model() const { return model_; }

 private:
  SlbError check(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) const;
  void close_loop_if_complete();
  std::vector<Word> read_entries(std::uint32_t arg) const;

  SlbModel model_;
  SlbSequence sequence_;
  SlbOp op_ = SlbOp::Clear;  ///< of the command in progress
  bool more_ = false;
  std::uint32_t depth_ = 0;     ///< its argument read as bias or margin
  std::size_t items_left_ = 0;  ///< of it
  std::uint16_t index_ = 0;     ///< of its next item
};

}  // namespace gnomon::golden::slb
