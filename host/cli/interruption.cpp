// SPDX-License-Identifier: Apache-2.0
// Ctrl-C as a stop token.
#include "host/cli/interruption.hpp"

#include <chrono>

namespace gnomon::cli {

Interruption::Interruption()
    : watcher_([this](const std::stop_token& ending) {
        while (!ending.stop_requested() && !requested())
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        if (requested()) source_.request_stop();
      }) {}

}  // namespace gnomon::cli
