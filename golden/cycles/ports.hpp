// SPDX-License-Identifier: Apache-2.0
// The hardware's way to memory, cycle by cycle: command words that are fetched, result words that are
// written, lines of the caches, over one master (docs/cycle-model.md, "Behind the bus").
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/cycles.hpp>
#include <vector>

#include "dram.hpp"
#include "line_cache.hpp"
#include "run.hpp"

namespace gnomon::golden::cycles {

/// Command words on their way from memory to the decoder.
class CommandFetch {
 public:
  explicit CommandFetch(std::uint32_t words_a_beat)
      : lanes_(words_a_beat), room_(kQueueWords / words_a_beat) {}

  /// So many words are in memory, the first of all included.
  void expect(std::uint64_t words) { known_ = std::max(known_, words); }
  /// The decoder sees a word.
  bool word() const { return skid_ != 0; }
  /// Every word that is known of was taken.
  bool over() const { return taken_ == known_; }
  bool asks() const { return burst() != 0 && bursts_ < kBursts && room_ >= beats(burst()); }
  std::uint64_t next() const { return asked_; }
  std::uint32_t beats_of_next() const { return beats(burst()); }
  void ask();
  /// The end of a cycle in which the decoder took a word or not and a beat came or not.
  void cycle(bool takes, bool beat, bool last);

 private:
  static constexpr std::uint32_t kBurstWords = 64, kBursts = 8, kQueueWords = 512;
  std::uint32_t burst() const;
  std::uint32_t beats(std::uint32_t words) const { return (words + lanes_ - 1) / lanes_; }

  std::uint32_t lanes_;
  std::uint64_t known_ = 0, asked_ = 0, came_ = 0, given_ = 0, taken_ = 0;  ///< words
  std::uint32_t bursts_ = 0, room_;                                         ///< room: in beats
  std::uint32_t skid_ = 0;
  bool asked_now_ = false;
};

/// Result words on their way to memory.
class ResultDma {
 public:
  static constexpr std::uint32_t kLineWords = 8;
  static constexpr std::uint64_t kRingWords = std::uint64_t{1} << 16U;

  /// `software`: cycles from a full ring to an empty one.
  explicit ResultDma(Cycle software) : software_(software) {}
  bool room() const { return skid_ < 2; }
  /// Nothing goes to memory until software has taken what is there.
  bool full() const { return words_ - taken_ >= kRingWords; }
  bool writes() const { return send_ && under_way_ < kBursts; }
  std::uint64_t first() const { return words_ - gathered_; }  ///< of what is written, counted since reset
  std::uint32_t words() const { return gathered_; }
  void answered() { answered_now_ = true; }
  /// The end of a cycle in which a unit gave a word or not and what was gathered went or not.
  void cycle(Cycle now, bool gives, bool sent, bool flush);

 private:
  static constexpr std::uint32_t kBursts = 32;
  static constexpr Cycle kNotAsked = UINT64_MAX;
  void empty_ring(Cycle now, bool room);

  Cycle software_, emptied_ = kNotAsked;
  std::uint64_t words_ = 0, taken_ = 0;  ///< since reset; by software
  std::uint32_t skid_ = 0, gathered_ = 0, under_way_ = 0;
  bool send_ = false, answered_now_ = false;
};

/// Memories that may lie behind a cache, in their order in memory and at the line port.
enum class CachedMemory : std::uint8_t { Plane, Lanes, Fragments, Heads, Nodes, Records };
inline constexpr std::size_t kCachedMemories = 6;

/// Grants users by priority; one that has waited for more than 64 grants of others goes first once.
template <std::size_t kUsers>
class Grant {
 public:
  /// Who of those who want goes; they must be some.
  std::size_t choose(const std::array<bool, kUsers>& wants);

 private:
  static constexpr int kPatience = 64;
  std::array<int, kUsers> waited_{};
};

class Ports {
 public:
  Ports(const HardwareConfig& config, const SystemTiming& timing);

  CommandFetch& commands() { return commands_; }
  const CommandFetch& commands() const { return commands_; }
  bool word() const { return commands_.word(); }
  /// A result is taken in this cycle, if one is given.
  bool room() const { return results_.room(); }
  /// What a cycle is in which a result is not taken.
  Cause held_back() const { return results_.full() ? Cause::OutputBlocked : Cause::MemoryWait; }
  /// Behind a cache of its own from now on. Memories come in their order.
  void add_cache(CachedMemory memory, int size_log2, int lines_log2);
  bool has(CachedMemory memory) const { return place_of(memory) != kNoCache; }
  CacheClock& cache(CachedMemory memory) { return caches_[place_of(memory)]; }
  const CacheClock& cache(CachedMemory memory) const { return caches_[place_of(memory)]; }
  Cycle now() const { return now_; }
  /// One cycle: the decoder takes a word, a unit gives a result; `quiet`: nothing is under way in any unit.
  void cycle(bool takes, bool gives, bool quiet);

 private:
  static constexpr std::uint32_t kMostIds = 32, kCommandUser = kMostIds;
  static constexpr std::size_t kNoCache = SIZE_MAX;
  static constexpr std::size_t kOverCommands = 0, kOverLines = 1;
  struct Read {
    std::uint32_t user = 0, beats = 0;
    Cycle first = 0;
  };
  struct Written {
    bool is_line = false;
    std::uint32_t id = 0;
    Cycle at = 0;
  };
  /// A burst that has the address or data channel.
  struct Burst {
    std::uint64_t address = 0, bytes = 0;
    std::uint32_t user = 0, beats = 0;
    Cycle at = CacheClock::kNever;  ///< its address; of a write its last beat
  };
  struct Id {
    bool busy = false;
    std::size_t cache = 0;
    std::uint32_t number = 0;
  };
  /// A line at the line port.
  struct Line {
    std::uint64_t address = 0;
    std::uint32_t id = 0;
    Cycle from = 0;
  };
  struct Way {
    std::vector<Id> ids;
    std::deque<Line> skid;
    std::size_t turn = 0;
  };

  std::size_t place_of(CachedMemory memory) const { return places_[static_cast<std::size_t>(memory)]; }
  void hand_out_answers();
  void hand_out_line();
  void reach_memory();
  void start_read();
  bool start_write();
  template <typename Wishes, typename Take>
  void offer_line(Way& way, const Wishes& wishes, const Take& take);

  SystemTiming timing_;
  std::uint32_t beat_bytes_;
  std::uint64_t planes_;  ///< where lines lie
  Cycle now_ = 0;
  CommandFetch commands_;
  ResultDma results_;
  std::vector<CacheClock> caches_;
  std::array<std::size_t, kCachedMemories> places_;  ///< in caches_
  std::uint32_t lines_ = 0;                          ///< of all memories behind caches
  DramClock dram_;
  std::deque<Read> reads_;
  std::deque<Written> written_;
  std::uint32_t given_ = 0;                ///< beats of the oldest read
  bool beat_ = false, last_beat_ = false;  ///< of commands, in this cycle
  Burst reading_, writing_;
  Way fetches_, backs_;
  std::vector<Cycle> whole_;  ///< by id, lines that have come, from then on
  Cycle handed_ = 0;          ///< the next one is handed over from then on
  Grant<2> read_grant_, write_grant_;
};

}  // namespace gnomon::golden::cycles
