// SPDX-License-Identifier: Apache-2.0
// What every engine does: take command words, give result words. Nothing above this interface knows which
// engine runs.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/config.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::golden {

using Word = std::uint64_t;

/// Takes result words in command order.
using ResultSink = std::function<void(std::span<const Word>)>;

/// Named counters (docs/command-stream.md). Event counters are the same on all engines; cycle counters
/// ("cycles.<pass>.<cause>") exist only where cycles do.
struct Counters {
  std::map<std::string, std::uint64_t> events;
  std::map<std::string, std::uint64_t> cycles;
};

/// An engine is built for one HardwareConfig. Words may be submitted in pieces of any size, also in the
/// middle of a command; state persists from one submit to the next.
class Engine {
 public:
  virtual ~Engine() = default;

  virtual std::string_view name() const = 0;
  virtual const HardwareConfig& config() const = 0;
  /// Takes all words; results so far may already go to the sink of the next drain.
  virtual void submit(std::span<const Word> words) = 0;
  /// Runs until everything submitted is done, and gives all results not yet given.
  virtual void drain(const ResultSink& sink) = 0;
  virtual Counters counters() const = 0;
  /// As after power-up: registers 0, plane empty, counters 0, nothing pending.
  virtual void reset() = 0;
  /// Depth codes of the whole plane, row-major (v * side + u), kEmpty where empty. Only between drain and
  /// submit.
  virtual std::vector<std::uint32_t> read_plane() = 0;
};

/// What read_plane gives for an empty entry.
inline constexpr std::uint32_t kEmpty = 0xFFFFFFFFu;

}  // namespace gnomon::golden
