// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a flag that long runs look at.
#pragma once

#include <atomic>
#include <csignal>

namespace gnomon::sim {

/// While it lives, SIGINT and SIGTERM set flag() instead of ending the program; a second one ends it as
/// usual. One at a time.
class InterruptFlag {
 public:
  InterruptFlag();
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;

  /// For RtlOptions::abort.
  const std::atomic<bool>& flag() const;

 private:
  struct sigaction old_interrupt_ {
  }, old_terminate_{};
};

}  // namespace gnomon::sim
