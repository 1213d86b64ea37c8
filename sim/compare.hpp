// SPDX-License-Identifier: Apache-2.0
// Runs one stream on two engines and compares every result word.
#pragma once

#include <cstdint>
#include <functional>
#include <gnomon/golden/engine.hpp>
#include <gnomon/golden/stream.hpp>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/rtl_engine.hpp"

namespace gnomon::sim {

/// One result word that is not what the reference says.
struct Difference {
  std::uint64_t result = 0;            ///< number of the result word in the stream, from 0
  std::optional<Word> expected;        ///< nothing: the reference gave no such word
  std::optional<Word> actual;          ///< nothing: the hardware gave no such word
  std::optional<std::uint64_t> cycle;  ///< at which the word left the hardware
  std::uint32_t command_index = 0;
  golden::Header command;
  std::uint32_t item_index = 0;  ///< number of the result among the command's: of the item, of the entry read
  std::optional<std::uint32_t> raw_word;  ///< the word is this raw word of an entry (golden::ResultOrigin)
  std::optional<Word> item;               ///< for commands that answer each item
  bool after_stream = false;  ///< the stream accounts for no such word; the command fields mean nothing then
};

/// A counter that differs.
struct CounterDifference {
  std::string name;
  std::uint64_t expected = 0, actual = 0;
};

struct CompareOptions {
  bool stop_at_first = false;  ///< do not run the rest of the stream after a difference
  bool counters = true;        ///< compare the event counters when the stream is done
  bool plane = false;          ///< compare every plane entry when the stream is done
  bool keep_partial = false;   ///< CycleLimit and Aborted end the comparison instead of being passed on
};

/// What was compared and what came of it.
struct CompareReport {
  golden::HardwareConfig config;
  std::uint32_t seed = 0;             ///< of the rtl engine
  std::uint64_t commands = 0;         ///< in the stream
  std::uint64_t words_compared = 0;   ///< result words that both engines gave
  std::uint64_t words_differing = 0;  ///< of those
  std::uint64_t expected_words = 0, actual_words = 0;
  std::optional<Difference> first;
  std::vector<CounterDifference> counters;
  std::uint64_t plane_entries_compared = 0, plane_entries_differing = 0;
  /// Not empty: the comparison was ended before the stream was, and why; what was not reached is no
  /// difference.
  std::string partial;
  std::string fault;  ///< not empty: the hardware hung or an assertion failed, and the comparison ended there
  golden::Counters rtl_counters;
  std::uint64_t cycles = 0;  ///< of the hardware since reset

  /// At least one word was compared, all are equal, there are as many as expected, counters are equal, no
  /// fault.
  bool passed() const;
  /// As passed, but a stream without any result word is no failure.
  bool consistent() const;
};

/// Both engines must be in reset state and have the same configuration (else std::invalid_argument). The
/// reference leads; results of the hardware are checked while it runs. HangError and RtlFault end up in the
/// report, so do CycleLimit and Aborted if they are to; everything else is passed on.
CompareReport compare(golden::Engine& reference, RtlEngine& rtl, std::span<const Word> stream,
                      const CompareOptions& options = {}, std::uint32_t seed = 0);

/// Several lines for a person. `passed()` reports end with "N words compared, 0 differ".
std::string to_text(const CompareReport& report);
/// Keys as documented in docs/simulation.md.
nlohmann::json to_json(const CompareReport& report);

}  // namespace gnomon::sim
