// SPDX-License-Identifier: Apache-2.0
// Requests into both caches or into neither; lines down the columns.
#include "slb_memory.hpp"

#include <algorithm>
#include <bit>

namespace gnomon::golden::cycles {
namespace {

constexpr int kSlotsLog2 = 4, kLineBitsLog2 = 9, kColumnStepLog2 = 3;
constexpr std::size_t kEntries = 4;  // places for them
constexpr Cycle kServedStages = 2;   // from the service of a read to its entry
constexpr std::uint8_t kReads = 1;

/// Pixels whose fragments share a line.
int places_log2(const slb::SlbConfig& config) {
  constexpr int kFlags = 2;  // open, overflow
  const int bits =
      config.count_bits() + slb::kCornerBits + kFlags + config.frags * (config.fragment_bits() + 1);
  return kLineBitsLog2 - static_cast<int>(std::bit_width(static_cast<unsigned>(bits - 1)));
}

/// The number of a line of 2^places_log2 pixels: down the columns, each of which begins eight lines on.
std::uint32_t line_of_pixel(std::uint32_t index, int plane_log2, int places_log2) {
  const std::uint32_t rows = 1U << plane_log2;
  const std::uint32_t row = index >> plane_log2, column = (index & (rows - 1)) >> places_log2;
  return column << plane_log2 | ((row + (column << kColumnStepLog2)) & (rows - 1));
}

}  // namespace

SlbMemory::SlbMemory(const slb::SlbConfig& config)
    : plane_log2_(config.plane_log2),
      slots_log2_(std::min(config.plane_log2, kSlotsLog2)),
      places_log2_(places_log2(config)),
      marks_(std::size_t{1} << lane_lines_log2(config)) {}

int SlbMemory::lane_lines_log2(const slb::SlbConfig& config) {
  return 2 * config.plane_log2 - std::min(config.plane_log2, kSlotsLog2);
}

int SlbMemory::fragment_lines_log2(const slb::SlbConfig& config) {
  return 2 * config.plane_log2 - places_log2(config);
}

void SlbMemory::begin(Ports& ports) {
  room_ = entries_.size() < kEntries;
  if (!held_) return;
  const CacheClock::Request lane{
      .line = held_->lane, .writes = held_->writes, .kind = held_->reads ? kReads : std::uint8_t{0}};
  const CacheClock::Request fragments{
      .line = held_->fragments, .writes = held_->writes_fragments, .line_wanted = held_->with_fragments};
  CacheClock& lanes = ports.cache(CachedMemory::Lanes);
  CacheClock& others = ports.cache(CachedMemory::Fragments);
  if (!lanes.takes(lane, ports.now()) || !others.takes(fragments, ports.now())) return;
  lanes.look_up(lane, ports.now());
  others.look_up(fragments, ports.now());
  held_.reset();
}

/// A line's mark tells whether any of its pixels has fragments; chains set it as they are taken.
void SlbMemory::take(const SlbRequest& request) {
  using enum SlbRequest::Kind;
  std::uint8_t& mark = marks_[request.index >> slots_log2_];
  const bool chain = request.kind == Chain;
  const bool looks = request.kind == Read || request.kind == Sample;
  held_ = {.lane = line_of_pixel(request.index, plane_log2_, slots_log2_),
           .fragments = line_of_pixel(request.index, plane_log2_, places_log2_),
           .with_fragments = chain || (looks && mark != 0),
           .reads = request.kind == Read,
           .writes = request.writes && request.kind != Read,
           .writes_fragments = chain};
  if (chain) mark = 1;
}

void SlbMemory::serve(Ports& ports) {
  CacheClock& lanes = ports.cache(CachedMemory::Lanes);
  CacheClock& fragments = ports.cache(CachedMemory::Fragments);
  if (!lanes.ready(ports.now()) || !fragments.ready(ports.now())) return;
  const bool reads = lanes.oldest().kind == kReads;
  if (reads && !room_) return;
  if (reads) entries_.push_back(ports.now() + kServedStages);
  lanes.serve(ports.now());
  fragments.serve(ports.now());
}

bool SlbMemory::idle(const Ports& ports) const {
  return !held_ && entries_.empty() && ports.cache(CachedMemory::Lanes).idle(ports.now()) &&
         ports.cache(CachedMemory::Fragments).idle(ports.now());
}

}  // namespace gnomon::golden::cycles
