// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a stop token.
#pragma once

#include <stdexcept>
#include <stop_token>
#include <thread>

#include "sim/interrupt.hpp"

namespace gnomon::cli {

/// Work was left off because somebody asked for it.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// While it lives, SIGINT and SIGTERM request a stop; a second one ends the program as usual.
class Interruption {
 public:
  Interruption();

  std::stop_token token() const { return source_.get_token(); }
  bool requested() const { return signal_.flag().load(); }
  /// For the simulation, which looks at a flag.
  const std::atomic<bool>& flag() const { return signal_.flag(); }
  /// Throws Interrupted if a stop was requested.
  void check() const {
    if (requested()) throw Interrupted();
  }

 private:
  sim::InterruptFlag signal_;
  std::stop_source source_;
  std::jthread watcher_;  ///< a signal handler may set a flag, but not request a stop
};

}  // namespace gnomon::cli
