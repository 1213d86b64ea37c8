// SPDX-License-Identifier: Apache-2.0
// Executes commands word by word, with their errors: what the hardware answers (docs/slb.md, "Commands").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/codec.hpp>
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

  /// A command with an op of this unit and all its items. In error it has no effect.
  SlbOutcome execute(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::span<const Word> items);

  SlbModel& model() { return model_; }
  const SlbModel& model() const { return model_; }

 private:
  SlbError check(std::uint8_t op, std::uint8_t flags, std::uint32_t arg, std::size_t count) const;
  bool allowed(SlbOp op) const;
  std::vector<Word> read_entries(std::uint32_t arg) const;

  SlbModel model_;
};

}  // namespace gnomon::golden::slb
