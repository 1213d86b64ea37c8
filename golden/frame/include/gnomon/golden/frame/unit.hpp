// SPDX-License-Identifier: Apache-2.0
// The frame buffer's commands, and what it keeps of a resolve pass (docs/frame-buffer.md).
#pragma once

#include <gnomon/golden/frame/memory.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::golden::frame {

struct FrameCounters {
  std::uint64_t kept = 0, overwritten = 0, lookups = 0, lookups_empty = 0, bricks = 0;
  bool operator==(const FrameCounters&) const = default;
};
/// Under the names of the page.
std::vector<std::pair<std::string, std::uint64_t>> named(const FrameCounters& counters);

/// Commands given to it are sound: known flags, no bad argument.
class FrameUnit {
 public:
  /// `config` must be legal.
  explicit FrameUnit(const FrameConfig& config) : config_(config), memory_(config) {}

  /// Begins CLEAR_FRAME or LOOKUP_FRAME.
  void begin(FrameOp op, std::uint8_t flags, std::uint32_t arg, std::size_t count);
  /// Some of the items of a LOOKUP_FRAME, and the words that are full then.
  std::vector<Word> take(std::span<const Word> items);

  /// The result words of some voxels of a resolve command with KEEP. `items` and `results` run alike.
  void keep(std::uint32_t layer, std::span<const Word> items, std::span<const Word> results);

  const FrameMemory& memory() const { return memory_; }
  const FrameCounters& counters() const { return counters_; }

 private:
  void look_up(const Cell& cell, std::vector<Word>& results);
  void read_brick(const Cell& cell, std::vector<Word>& results);

  FrameConfig config_;
  FrameMemory memory_;
  FrameCounters counters_;

  // The command at hand.
  bool whole_bricks_ = false;
  std::uint32_t layer_ = 0;
  std::size_t items_left_ = 0;
  std::vector<State> pending_;  ///< states of a word that is not full yet
};

}  // namespace gnomon::golden::frame
