// SPDX-License-Identifier: Apache-2.0
// The nearest depth of every plane entry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gnomon::golden {

/// Depth codes of up to 24 bits below an epoch of 8. Clearing lowers the epoch, so everything written before
/// compares as farther than anything written after: a clear costs nothing, and nearest stays a plain minimum.
class Plane {
 public:
  explicit Plane(std::size_t entries) : entries_(entries, kUntouched) {}

  std::size_t size() const { return entries_.size(); }

  void clear() {
    if (epoch_ == 0) {
      entries_.assign(entries_.size(), kUntouched);
      epoch_ = kFirstEpoch;
    } else {
      --epoch_;
    }
  }

  /// Keeps the nearer of `depth` and the entry's; true if the entry became nearer.
  bool keep_nearest(std::size_t index, std::uint32_t depth) {
    const std::uint32_t candidate = epoch_ << 24 | depth;
    if (candidate >= entries_[index]) return false;
    entries_[index] = candidate;
    return true;
  }

  bool present(std::size_t index) const { return entries_[index] >> 24 == epoch_; }
  /// Only where present.
  std::uint32_t depth(std::size_t index) const { return entries_[index] & 0xFFFFFF; }

 private:
  static constexpr std::uint32_t kUntouched = 0xFFFFFFFF;
  static constexpr std::uint32_t kFirstEpoch = 254;

  std::vector<std::uint32_t> entries_;
  std::uint32_t epoch_ = kFirstEpoch;
};

}  // namespace gnomon::golden
