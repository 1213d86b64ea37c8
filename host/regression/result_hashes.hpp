// SPDX-License-Identifier: Apache-2.0
// Hashes of the result words of runs, whichever engine they are compared on: golden's words are the words.
#pragma once

#include <gnomon/golden/engine.hpp>
#include <list>
#include <string>
#include <vector>

#include "host/pipeline/run.hpp"

namespace gnomon::regression {

/// Makes golden engines and remembers what they gave. Must outlive them.
class ResultHashes {
 public:
  /// For RunRequest::make_golden.
  pipeline::GoldenFactory factory();
  /// Of each engine's words so far, in the order in which the engines were made.
  std::vector<std::string> hashes() const;

 private:
  std::list<std::string> bytes_;  ///< of each engine's words, low byte first; engines hold references
};

}  // namespace gnomon::regression
