// SPDX-License-Identifier: Apache-2.0
// What a cycle does is decided from what the cycles before left, as in the hardware.
#include "ports.hpp"

#include <algorithm>

namespace gnomon::golden::cycles {
namespace {

// The host's layout of the DRAM.
constexpr std::uint64_t kCommandRing = 0x1000, kJobTable = 0x10000;
constexpr std::uint64_t kResults = 0x800000, kResultWords = ResultDma::kRingWords;
constexpr std::uint64_t kWordBytes = 8, kLineBytes = 64, kBlock = 4096;
constexpr std::uint64_t kCommands = kResults + kResultWords * kWordBytes;

// What the firmware takes to empty a result ring that is full; measured, and no more than a guide.
constexpr Cycle kSoftware = 620, kSoftwareAccesses = 2;

constexpr std::uint64_t in_blocks(std::uint64_t bytes) {
  return (bytes + kBlock - 1) / kBlock * kBlock;
}

/// Planes and lists have the end of the DRAM: room for what they may take at most.
std::uint64_t bytes_of_planes(const HardwareConfig& config) {
  const std::uint64_t entries = std::uint64_t{1} << (2 * config.plane_log2);
  const std::uint64_t pixels = std::uint64_t{1} << (2 * config.slb_plane_log2);
  std::uint64_t bytes = in_blocks(4 * entries);  // the plane, whatever else is built
  if (config.en_slb) bytes += in_blocks(4 * pixels) + in_blocks(64 * pixels);
  if (config.en_vpu_topology)
    bytes += in_blocks(8 * entries) + in_blocks(std::uint64_t{16} << config.nodes_log2) +
             in_blocks(std::uint64_t{32} << config.quads_log2);
  return bytes;
}

}  // namespace

std::uint32_t CommandFetch::burst() const {
  return static_cast<std::uint32_t>(
      std::min<std::uint64_t>(known_ - asked_, kBurstWords - asked_ % kBurstWords));
}

void CommandFetch::ask() {
  const std::uint32_t words = burst();
  asked_ += words;
  room_ -= beats(words);
  ++bursts_;
}

void CommandFetch::cycle(bool takes, bool beat, bool last) {
  const bool gives = came_ > given_ && skid_ < 2;
  if (beat) came_ = std::min(came_ + lanes_, asked_);
  if (last) --bursts_;
  if (gives) {
    ++given_;
    ++skid_;
    if (given_ % lanes_ == 0 || given_ == known_) ++room_;
  }
  if (takes) {
    ++taken_;
    --skid_;
  }
}

void ResultDma::cycle(Cycle now, bool gives, bool sent, bool flush) {
  const bool room = !full();
  const bool takes = skid_ != 0 && room && (!send_ || sent);
  const bool line_ends = words_ % kLineWords == kLineWords - 1;
  if (takes)
    send_ = line_ends;
  else if (sent)
    send_ = false;
  else
    send_ = send_ || (gathered_ != 0 && ((flush && skid_ == 0) || !room));
  gathered_ = (sent ? 0 : gathered_) + (takes ? 1 : 0);
  words_ += takes ? 1 : 0;
  empty_ring(now, room);
  skid_ = skid_ + (gives ? 1 : 0) - (takes ? 1 : 0);
  under_way_ = under_way_ + (sent ? 1 : 0) - (answered_now_ ? 1 : 0);
  answered_now_ = false;
}

/// Software hears of a full ring, takes everything and makes room.
void ResultDma::empty_ring(Cycle now, bool room) {
  if (room || skid_ == 0) return;
  if (emptied_ == kNotAsked) {
    emptied_ = now + software_;
  } else if (emptied_ == now) {
    taken_ = words_;
    emptied_ = kNotAsked;
  }
}

template <std::size_t kUsers>
std::size_t Grant<kUsers>::choose(const std::array<bool, kUsers>& wants) {
  std::size_t granted = kUsers;
  for (std::size_t i = kUsers; i-- > 0;)
    if (wants[i]) granted = i;
  for (std::size_t i = kUsers; i-- > 0;)
    if (wants[i] && waited_[i] > kPatience) granted = i;
  for (std::size_t i = 0; i < kUsers; ++i) {
    if (!wants[i] || i == granted)
      waited_[i] = 0;
    else if (waited_[i] <= kPatience)
      ++waited_[i];
  }
  return granted;
}

Ports::Ports(const HardwareConfig& config, const SystemTiming& timing)
    : timing_(timing),
      beat_bytes_(static_cast<std::uint32_t>(timing.axi_data_bits) / 8),
      planes_(timing.dram_bytes - bytes_of_planes(config)),
      commands_(beat_bytes_ / static_cast<std::uint32_t>(kWordBytes)),
      results_(kSoftware + kSoftwareAccesses * timing.latency),
      dram_(timing),
      whole_(std::size_t{1} << timing.line_ids_log2, CacheClock::kNever) {
  places_.fill(kNoCache);
  fetches_.ids.resize(whole_.size());
  backs_.ids.resize(whole_.size());
  for (const std::uint64_t place : {kJobTable, kCommandRing}) dram_.open(place);
}

/// Each at a multiple of a block.
void Ports::add_cache(CachedMemory memory, int size_log2, int lines_log2) {
  places_[static_cast<std::size_t>(memory)] = caches_.size();
  caches_.emplace_back(size_log2, lines_log2, lines_, timing_.line_ids_log2);
  lines_ += std::max(static_cast<std::uint32_t>(kBlock / kLineBytes), std::uint32_t{1} << lines_log2);
}

void Ports::cycle(bool takes, bool gives, bool quiet) {
  offer_line(
      fetches_, [](const CacheClock& cache) -> const auto& { return cache.fetches(); },
      [](CacheClock& cache) { cache.fetch_taken(); });
  offer_line(
      backs_, [](const CacheClock& cache) -> const auto& { return cache.backs(); },
      [](CacheClock& cache) { cache.back_taken(); });
  reach_memory();
  start_read();
  const bool sent = start_write();
  beat_ = last_beat_ = false;
  hand_out_answers();
  hand_out_line();
  commands_.cycle(takes, beat_, last_beat_);
  results_.cycle(now_, gives, sent, quiet);
  for (CacheClock& cache : caches_) cache.end_cycle(now_);
  ++now_;
}

/// Caches take turns at the line port; a line that goes through it has one of its numbers.
template <typename Wishes, typename Take>
void Ports::offer_line(Way& way, const Wishes& wishes, const Take& take) {
  if (caches_.empty() || way.skid.size() == 2) return;
  const auto id = std::ranges::find(way.ids, false, &Id::busy);
  if (id == way.ids.end()) return;
  for (std::size_t i = 0; i < caches_.size(); ++i) {
    const std::size_t who = (way.turn + i) % caches_.size();
    CacheClock& cache = caches_[who];
    if (wishes(cache).empty() || wishes(cache).front().from > now_) continue;
    const CacheClock::Wish wish = wishes(cache).front();
    take(cache);
    *id = {true, who, wish.number};
    way.skid.push_back({planes_ + kLineBytes * (std::uint64_t{cache.first_line()} + wish.line),
                        static_cast<std::uint32_t>(id - way.ids.begin()), now_ + 1});
    way.turn = (who + 1) % caches_.size();
    return;
  }
}

/// What stands on the address channel, and a write whose last beat passes.
void Ports::reach_memory() {
  if (reading_.at == now_) {
    const Cycle end = dram_.access(now_, reading_.address, reading_.bytes);
    const Cycle first = end - std::min<Cycle>(end, reading_.beats - 1);
    reads_.push_back({reading_.user, reading_.beats, std::max(first, now_ + 1)});
  }
  if (writing_.at == now_)
    written_.push_back(
        {writing_.user != kMostIds, writing_.user, dram_.access(now_, writing_.address, writing_.bytes)});
}

void Ports::start_read() {
  const bool line = !fetches_.skid.empty() && fetches_.skid.front().from <= now_;
  const bool command = commands_.asks();
  if (!line && !command) return;
  if (read_grant_.choose({command, line}) == kOverCommands) {
    const std::uint32_t beats = commands_.beats_of_next();
    reading_ = {kCommands + kWordBytes * commands_.next(), std::uint64_t{beats} * beat_bytes_, kCommandUser,
                beats, now_ + 1};
    commands_.ask();
  } else {
    const Line& next = fetches_.skid.front();
    const auto beats = static_cast<std::uint32_t>(kLineBytes) / beat_bytes_;
    reading_ = {next.address, kLineBytes, next.id, beats, now_ + 1};
    fetches_.skid.pop_front();
  }
}

/// Whether what the results have gathered goes.
bool Ports::start_write() {
  if (writing_.at > now_ && writing_.at != CacheClock::kNever) return false;
  const bool line = !backs_.skid.empty() && backs_.skid.front().from <= now_;
  if (!line && !results_.writes()) return false;
  const bool result = write_grant_.choose({results_.writes(), line}) == 0;
  if (result) {
    const std::uint64_t first = results_.first() % kResultWords;
    const std::uint64_t lanes = beat_bytes_ / kWordBytes;
    const std::uint64_t last = first + results_.words() - 1;
    writing_ = {kResults + kWordBytes * first, kWordBytes * results_.words(), kMostIds,
                static_cast<std::uint32_t>(last / lanes - first / lanes + 1), 0};
  } else {
    const Line& next = backs_.skid.front();
    writing_ = {next.address, kLineBytes, next.id, static_cast<std::uint32_t>(kLineBytes) / beat_bytes_, 0};
    backs_.skid.pop_front();
  }
  writing_.at = now_ + writing_.beats;
  return result;
}

void Ports::hand_out_answers() {
  if (!reads_.empty() && reads_.front().first <= now_) {
    const Read& read = reads_.front();
    const bool last = ++given_ == read.beats;
    if (read.user == kCommandUser) {
      beat_ = true;
      last_beat_ = last;
    } else if (last) {
      whole_[read.user] = now_ + 1;
    }
    if (last) {
      given_ = 0;
      reads_.pop_front();
    }
  }
  if (written_.empty() || written_.front().at > now_) return;
  const Written written = written_.front();
  written_.pop_front();
  if (!written.is_line) return results_.answered();
  Id& id = backs_.ids[written.id];
  caches_[id.cache].written(id.number, now_);
  id.busy = false;
}

/// Whole lines go to their caches one at a time.
void Ports::hand_out_line() {
  if (now_ < handed_) return;
  const auto line = std::ranges::find_if(whole_, [&](Cycle from) { return from < now_; });
  if (line == whole_.end()) return;
  Id& id = fetches_.ids[static_cast<std::size_t>(line - whole_.begin())];
  caches_[id.cache].came(id.number, now_);
  id.busy = false;
  *line = CacheClock::kNever;
  handed_ = now_ + 2;
}

}  // namespace gnomon::golden::cycles
