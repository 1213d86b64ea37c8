// SPDX-License-Identifier: Apache-2.0
// Commands and their cycles: the tables of docs/cycle-model.md.
#include "cycle_model.hpp"

#include <algorithm>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/frame/codec.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <gnomon/golden/topology/codec.hpp>
#include <utility>

#include "fill.hpp"

namespace gnomon::golden::cycles {
namespace {

constexpr int kLineLog2 = 4;         // entries that are scrubbed in a cycle
constexpr Cycle kGenerations = 255;  // clears after which every line was scrubbed
constexpr Cycle kPerspectiveStages = 8;
constexpr Cycle kProjectStages = 5;   // off the plane; and the latency, and a write
constexpr Cycle kResolveStages = 13;  // and the latency
constexpr Cycle kKeepStages = 1;      // more, and the latency again
constexpr Cycle kCoverStages = 1;     // off the rows swept
constexpr Cycle kUpdateStages = 1;    // more where COVER updates the memory, and the latency
constexpr Cycle kWriteStages = 1;     // more where that writes
constexpr Cycle kQueryStages = 6;     // and the latency
constexpr Cycle kEndOfUnit = 1;       // a cycle in which the decoder sees that the unit is idle

enum class Kind { Slb, Topology, Frame, Core };

Kind kind_of(std::uint8_t op) {
  if (slb::is_slb_op(op)) return Kind::Slb;
  if (topology::is_topology_op(op)) return Kind::Topology;
  if (frame::is_frame_op(op)) return Kind::Frame;
  return Kind::Core;
}

bool is(const Header& header, Op op) {
  return header.op == static_cast<std::uint8_t>(op);
}
bool is(const Header& header, slb::SlbOp op) {
  return header.op == static_cast<std::uint8_t>(op);
}
bool is(const Header& header, frame::FrameOp op) {
  return header.op == static_cast<std::uint8_t>(op);
}
bool is(const Header& header, topology::TopologyOp op) {
  return header.op == static_cast<std::uint8_t>(op);
}

/// The pass of an op whose commands may follow each other without a barrier; none of others.
std::optional<Pass> streaming_pass(const Header& header) {
  if (is(header, Op::ProjectVoxels)) return Pass::Project;
  if (is(header, Op::ResolveVoxels)) return Pass::Resolve;
  if (is(header, slb::SlbOp::Loop)) return Pass::Draw;
  if (is(header, slb::SlbOp::Cover)) return Pass::Cover;
  if (is(header, slb::SlbOp::Query)) return Pass::Query;
  if (is(header, frame::FrameOp::LookupFrame)) return Pass::Read;
  if (is(header, topology::TopologyOp::PutQuads)) return Pass::Project;
  if (is(header, topology::TopologyOp::ResolveTopology)) return Pass::Resolve;
  return std::nullopt;
}

}  // namespace

Cycle CycleModel::share(int lines_log2) {
  return ((Cycle{1} << lines_log2) + kGenerations - 1) / kGenerations;
}

CycleModel::CycleModel(const HardwareConfig& config, const HardwareTiming& timing)
    : config_(config),
      timing_(timing),
      latency_(static_cast<Cycle>(timing.memory_latency)),
      late_(config.en_perspective ? kPerspectiveStages : 0) {
  if (config.en_slb) outline_.emplace(config.slb_config(), timing);
  if (config.en_frame_buffer) look_up_.emplace(timing);
  if (timing.system) ports_.emplace(config, *timing.system);
  if (timing.system && timing.system->cache_log2 != 0) build_caches(timing.system->cache_log2);
  reset_scrub();
  if (ports_) ports_->commands().expect(timing.system->job_words);
}

/// The silhouette-line buffer has half of a unit's cache for lanes and a quarter for fragments; topology mode
/// half for heads and a quarter each for nodes and records.
void CycleModel::build_caches(int size_log2) {
  ports_->add_cache(CachedMemory::Plane, size_log2, plane_lines_log2());
  if (config_.en_slb) {
    const slb::SlbConfig slb = config_.slb_config();
    ports_->add_cache(CachedMemory::Lanes, size_log2 - 1, SlbMemory::lane_lines_log2(slb));
    ports_->add_cache(CachedMemory::Fragments, size_log2 - 2, SlbMemory::fragment_lines_log2(slb));
    slb_memory_.emplace(slb);
    draw_.emplace(slb, timing_);
  }
  if (!config_.en_vpu_topology) return;
  ports_->add_cache(CachedMemory::Heads, size_log2 - 1, ListMemories::head_lines_log2(config_));
  ports_->add_cache(CachedMemory::Nodes, size_log2 - 2, ListMemories::node_lines_log2(config_));
  ports_->add_cache(CachedMemory::Records, size_log2 - 2, ListMemories::record_lines_log2(config_));
}

int CycleModel::plane_lines_log2() const {
  return 2 * config_.plane_log2 - kLineLog2;
}

/// One bit a line of a memory behind a cache, in words of 32, 16 of them scrubbed in a cycle.
int CycleModel::touched_lines_log2(int lines_log2) {
  return (lines_log2 > 10 ? lines_log2 - 5 : 5) - kLineLog2;
}

int CycleModel::slb_lines_log2() const {
  return 2 * config_.slb_plane_log2 - std::min(config_.slb_plane_log2, kLineLog2);
}

int CycleModel::frame_lines_log2() const {
  constexpr int kBrickLog2 = 2;
  return 3 * (config_.voxel_bits - kBrickLog2) + config_.frame_layers_log2 - kLineLog2;
}

/// All memories at once. The decoder sees the end of the plane's scrubbing as it happens, that of the others
/// a cycle later.
void CycleModel::reset_scrub() {
  Cycle scrubbed = cache() == nullptr ? Cycle{1} << plane_lines_log2()
                                      : (Cycle{1} << touched_lines_log2(plane_lines_log2())) + 1;
  const auto other = [&](bool there, int lines_log2) {
    if (there) scrubbed = std::max(scrubbed, (Cycle{1} << lines_log2) + 1);
  };
  if (cache() == nullptr) {
    other(config_.en_vpu_topology, plane_lines_log2());
  } else {
    other(config_.en_vpu_topology, touched_lines_log2(ListMemories::head_lines_log2(config_)));
    other(config_.en_vpu_topology, touched_lines_log2(ListMemories::node_lines_log2(config_)));
    other(config_.en_vpu_topology, touched_lines_log2(ListMemories::record_lines_log2(config_)));
  }
  other(config_.en_slb, slb_lines_log2());
  other(config_.en_frame_buffer, frame_lines_log2());
  spend(Pass::Clear, scrubbed);
}

void CycleModel::header(const Header& header, bool in_error, const slb::FillSweep& fill) {
  const auto pass = in_error ? std::nullopt : streaming_pass(header);
  if (!pass || header.op != command_.op) end_run(true);
  command_ = header;
  items_left_ = header.count;
  if (is(header, topology::TopologyOp::PutQuads) || is(header, topology::TopologyOp::ResolveTopology))
    if (!in_error) return begin_lists();
  if (slb_memory_ && !in_error && kind_of(header.op) == Kind::Slb) return slb_header(pass, fill);
  if (ports_ && pass && (*pass == Pass::Query || kind_of(header.op) == Kind::Core)) return begin_items(*pass);
  if (ports_ && !(pass && run_.open())) await_word(true);
  if (in_error) {
    spend(Pass::Control, 1);
    return give(Pass::Control);
  }
  if (pass) {
    if (!run_.open()) run_.begin(*pass, now_);
    run_.drained_from(take(1) + 1);
    return close_if_complete();
  }
  switch (kind_of(header.op)) {
    case Kind::Slb:
      return slb_command(fill);
    case Kind::Topology:
      if (is(header, topology::TopologyOp::ClearLists))
        return cache() ? clear_lists() : clear_unit(plane_lines_log2());
      if (cache()) return read_lists(topology::decode_entry_range(header.arg));
      return read(topology::decode_entry_range(header.arg).count, 0, kEndOfUnit);
    case Kind::Frame:
      return clear_unit(frame_lines_log2());
    case Kind::Core:
      return core_command();
  }
}

void CycleModel::core_command() {
  if (is(command_, Op::ClearPlane)) return clear_plane();
  if (is(command_, Op::ReadPlane))
    return ports_ ? read_plane() : read(decode_plane_range(command_.arg).count, 0, 0);
  spend(Pass::Control, 1);
  if (is(command_, Op::Fence)) give(Pass::Control);
}

/// Behind a cache lines that are on their way out hold it up; nothing is forgotten before they have arrived.
void CycleModel::clear_plane() {
  CacheClock* const plane = cache();
  if (plane == nullptr) return spend(Pass::Clear, 2 + share(plane_lines_log2()));
  spend(Pass::Clear, 1);
  while (!plane->can_be_cleared(now_)) spend(Pass::Clear, 0, 1);
  plane->clear();
  spend(Pass::Clear, 2 + share(touched_lines_log2(plane_lines_log2())));
}

void CycleModel::slb_command(const slb::FillSweep& fill) {
  switch (static_cast<slb::SlbOp>(command_.op)) {
    case slb::SlbOp::Clear:
      return clear_unit(slb_lines_log2());
    case slb::SlbOp::BeginObject:
      flat_ = (command_.flags & slb::kBeginFlat) != 0;
      return spend(Pass::Draw, 1);
    case slb::SlbOp::EndObject:
      return spend(Pass::Fill, 1);
    case slb::SlbOp::Fill:
      return this->fill(fill);
    default:
      return read(slb::decode_entry_range(command_.arg).count,
                  static_cast<Cycle>(config_.slb_config().entry_words()), kEndOfUnit);
  }
}

void CycleModel::fill(const slb::FillSweep& sweep) {
  const FillCycles cycles = fill_cycles(sweep, flat_, config_.slb_config(), timing_);
  spend(Pass::Fill, 1 + cycles.steps, cycles.idle - cycles.steps);
}

void CycleModel::clear_unit(int lines_log2) {
  spend(Pass::Clear, 1 + share(lines_log2), kEndOfUnit);
}

/// Entries are asked for one a cycle; the first answer comes L + 1 cycles later, each takes 1 + words cycles.
void CycleModel::read(Cycle entries, Cycle words, Cycle ends) {
  const Cycle until_first = latency_ + 1;
  const Cycle asking = std::min(entries, until_first);
  if (!ports_) return spend(Pass::Read, 1 + asking + entries * (1 + words), until_first - asking + ends);
  spend(Pass::Read, 1 + asking, until_first - asking + ends);
  for (Cycle word = 0; word < entries * (1 + words); ++word) give(Pass::Read);
}

void CycleModel::close_if_complete() {
  if (items_left_ != 0 || !is(command_, slb::SlbOp::Loop) || (command_.flags & slb::kLoopMore) != 0) return;
  if (slb_run_) return vertex_behind_cache({.closes = true});
  const Cycle taken = outline_->close(now_, run_);
  run_.take(taken, 1);
  elapse(taken + 1 - now_);
}

void CycleModel::items(std::size_t count, const topology::ListWork& work) {
  items_left_ -= static_cast<std::uint32_t>(count);
  if (put_) {
    for (const auto& quad : work.quads) put_->expect(quad.entries());
  } else if (cached_put_) {
    for (const auto& quad : work.quads) cached_put_->expect(quad);
  } else {
    walk_->expect(work, config_.en_frame_buffer && (command_.flags & frame::kKeep) != 0,
                  config_.en_frame_buffer && (command_.flags & frame::kQuiet) != 0);
  }
  for (std::size_t i = 0; i < count; ++i)
    while (!list_cycle(true, false, true)) continue;
}

void CycleModel::items(std::size_t count) {
  if (count == 0) return;
  items_left_ -= static_cast<std::uint32_t>(count);
  if (items_) return take_items(std::vector<Item>(count));
  if (!run_.open()) return control_items(count);
  if (is(command_, frame::FrameOp::LookupFrame)) return look_up(count);
  const Cycle last = take(count) + count - 1;
  if (is(command_, slb::SlbOp::Query)) return run_.drained_from(last + kQueryStages + latency_);
  const bool kept = config_.en_frame_buffer && (command_.flags & frame::kKeep) != 0;
  run_.drained_from(last + kResolveStages + late_ + latency_ + (kept ? kKeepStages + latency_ : 0));
}

void CycleModel::items(const ItemWork& work) {
  if (work.items == 0) return;
  items_left_ -= static_cast<std::uint32_t>(work.items);
  if (slb_run_) return pixels(work.each);
  if (items_) return take_items(work.each);
  if (ports_) return covers(work);
  const bool projects = is(command_, Op::ProjectVoxels);
  const Cycle stages = projects ? kProjectStages + late_ : kCoverStages;
  const Cycle updated = stages + (projects ? 0 : kUpdateStages) + latency_;
  const Cycle first = take(work.items);
  run_.drained_from(first + work.items - 1 + stages);
  if (work.last_updating) run_.drained_from(first + *work.last_updating + updated);
  if (work.last_writing) run_.drained_from(first + *work.last_writing + updated + kWriteStages);
}

void CycleModel::vertices(std::span<const Word> words) {
  const slb::SlbConfig config = config_.slb_config();
  for (const Word word : words) {
    slb::Vertex vertex = slb::decode_vertex(word, config);
    if (flat_) vertex.depth = 0;  // no quotient is wanted for it
    if (slb_run_) {
      vertex_behind_cache({.vertex = vertex});
      continue;
    }
    if (ports_) await_word(false);
    const Cycle taken = outline_->vertex(vertex, now_, run_);
    run_.take(taken, 1);
    elapse(taken - now_);
    take_word();
  }
  items_left_ -= static_cast<std::uint32_t>(words.size());
  close_if_complete();
}

CycleTable CycleModel::table() const {
  CycleModel ended = *this;
  ended.end_run(false);
  return ended.table_;
}

}  // namespace gnomon::golden::cycles
