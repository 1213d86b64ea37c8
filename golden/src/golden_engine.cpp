// SPDX-License-Identifier: Apache-2.0
// The command processor of docs/command-stream.md around the arithmetic of vpu.hpp, topology/unit.hpp,
// frame/unit.hpp and slb/unit.hpp.
#include <algorithm>
#include <gnomon/golden/golden_engine.hpp>
#include <stdexcept>
#include <utility>

#include "engine_state.hpp"
#include "resolve.hpp"
#include "told_items.hpp"

namespace gnomon::golden {
namespace {

HardwareConfig checked(const HardwareConfig& config) {
  if (const auto error = config.check()) throw std::invalid_argument(*error);
  return config;
}

HardwareTiming checked(const HardwareTiming& timing) {
  if (const auto error = timing.check()) throw std::invalid_argument(*error);
  return timing;
}

class GoldenEngine final : public Engine {
 public:
  GoldenEngine(const HardwareConfig& config, const std::optional<HardwareTiming>& timing)
      : config_(checked(config)), timing_(timing), state_(config_, timing_) {}

  std::string_view name() const override { return "golden"; }
  const HardwareConfig& config() const override { return config_; }
  void reset() override { state_ = State(config_, timing_); }

  void submit(std::span<const Word> words) override;
  void drain(const ResultSink& sink) override;
  Counters counters() const override;
  std::vector<std::uint32_t> read_plane() override;
  /// Only of the timed engine.
  CycleTable predicted() const { return state_.clock->model.table(); }

 private:
  void take_header(Word word);
  void execute(const Header& header);
  void take_items(std::span<const Word> items);
  void begin_slb(const Header& header);
  void begin_topology(const Header& header);
  void give(std::span<const Word> results);
  void give_states(std::span<const Word> items, std::span<const Word> states);
  void fence(const Header& header);
  void read_entries(const Header& header);
  void set_registers(std::span<const Word> values);
  void project(std::span<const Word> items);
  void resolve(std::span<const Word> items, bool two_sided);

  void tell_items(std::span<const Word> items);
  void tell_lists(std::size_t items);

  HardwareConfig config_;
  std::optional<HardwareTiming> timing_;
  State state_;
};

void GoldenEngine::submit(std::span<const Word> words) {
  if (state_.clock) state_.clock->model.submitted(words.size());
  while (!words.empty()) {
    if (state_.between_commands()) {
      take_header(words.front());
      words = words.subspan(1);
      continue;
    }
    const std::size_t missing = state_.command.count - state_.items_taken;
    const auto items = words.first(std::min(missing, words.size()));
    take_items(items);
    state_.items_taken += static_cast<std::uint32_t>(items.size());
    words = words.subspan(items.size());
  }
}

void GoldenEngine::drain(const ResultSink& sink) {
  const std::vector<Word> results = std::exchange(state_.results, {});
  if (!results.empty()) sink(results);
}

void GoldenEngine::take_header(Word word) {
  const Header header = decode_header(word);
  const auto index = static_cast<std::uint32_t>(state_.events.commands);  // modulo 2^32
  state_.command = header;
  state_.items_taken = 0;
  ++state_.events.commands;
  const auto error = state_.sequence.next(header);
  state_.ignore_items = error.has_value();
  if (error) {
    ++state_.events.errors;
    state_.sticky |= kStickyErrorSeen;
    state_.results.push_back(encode(ErrorResult{static_cast<std::uint8_t>(*error), index}));
  } else {
    execute(header);
  }
  if (state_.clock) state_.clock->model.header(header, error.has_value(), state_.clock->fill);
}

void GoldenEngine::execute(const Header& header) {
  if (slb::is_slb_op(header.op)) return begin_slb(header);
  if (topology::is_topology_op(header.op)) return begin_topology(header);
  if (frame::is_frame_op(header.op))
    return state_.frame->begin(static_cast<frame::FrameOp>(header.op), header.flags, header.arg,
                               header.count);
  switch (static_cast<Op>(header.op)) {
    case Op::ClearPlane:
      state_.plane.clear();
      break;
    case Op::Fence:
      fence(header);
      break;
    case Op::ReadPlane:
      read_entries(header);
      break;
    default:
      break;  // the items do the work
  }
}

void GoldenEngine::take_items(std::span<const Word> items) {
  if (state_.clock) tell_items(items);
  if (state_.ignore_items) return;
  const Header& header = state_.command;
  if (state_.clock && header.op == static_cast<std::uint8_t>(slb::SlbOp::Cover))
    return state_.clock->model.items(take_covers(*state_.slb, state_.clock->fill, items));
  if (slb::is_slb_op(header.op)) return give(state_.slb->take(items));
  if (topology::is_topology_op(header.op)) {
    const std::vector<Word> results = state_.topology->take(items);
    if (state_.clock) tell_lists(items.size());
    const bool states = header.op == static_cast<std::uint8_t>(topology::TopologyOp::ResolveTopology);
    return states ? give_states(items, results) : give(results);
  }
  if (frame::is_frame_op(header.op)) return give(state_.frame->take(items));
  switch (static_cast<Op>(header.op)) {
    case Op::SetRegisters:
      set_registers(items);
      break;
    case Op::ProjectVoxels:
      project(items);
      break;
    case Op::ResolveVoxels:
      resolve(items, (header.flags & kResolveTwoSided) != 0);
      break;
    default:
      break;  // the items of a NOP
  }
}

/// Those whose cycles depend on what becomes of them tell it themselves.
void GoldenEngine::tell_items(std::span<const Word> items) {
  const std::uint8_t op = state_.command.op;
  cycles::CycleModel& clock = state_.clock->model;
  if (state_.ignore_items) return clock.items(items.size());
  if (op == static_cast<std::uint8_t>(slb::SlbOp::Loop)) return clock.vertices(items);
  if (op == static_cast<std::uint8_t>(slb::SlbOp::Cover)) return;
  if (op == static_cast<std::uint8_t>(Op::ProjectVoxels) || topology::is_topology_op(op)) return;
  if (op == static_cast<std::uint8_t>(Op::ResolveVoxels) && clock.asks_for_items())
    return clock.items(
        {.items = items.size(), .each = resolved_items(state_.vpu, config_, items, state_.command.flags)});
  if (op == static_cast<std::uint8_t>(slb::SlbOp::Query) && clock.asks_for_pixels())
    return clock.items({.items = items.size(), .each = queried_items(state_.slb->model().config(), items)});
  clock.items(items.size());
}

void GoldenEngine::tell_lists(std::size_t items) {
  state_.clock->model.items(items, state_.clock->lists);
  state_.clock->lists = {};
}

void GoldenEngine::begin_slb(const Header& header) {
  const slb::SlbOutcome outcome = state_.slb->begin(header.op, header.flags, header.arg, header.count);
  if (outcome.error != slb::SlbError::None) throw std::logic_error("the unit refuses a command judged sound");
  give(outcome.results);
}

void GoldenEngine::begin_topology(const Header& header) {
  topology::ProjectionRegisters registers;
  for (std::size_t i = 0; i < registers.matrix.size(); ++i)
    registers.matrix[i] = state_.vpu.get(static_cast<Register>(i));
  registers.offset_factor = state_.vpu.get(Register::OffsetFactor);
  registers.perspective = state_.vpu.light().registers();
  state_.topology->set_registers(registers);
  const topology::TopologyOutcome outcome = state_.topology->begin(
      header.op, header.flags & ~frame::kResolveFlags & 0xFF, header.arg, header.count);
  if (outcome.error != topology::TopologyError::None)
    throw std::logic_error("the unit refuses a command judged sound");
  give(outcome.results);
}

void GoldenEngine::give(std::span<const Word> results) {
  state_.results.insert(state_.results.end(), results.begin(), results.end());
}

/// Of a resolve command: to the frame buffer, to the results, or both.
void GoldenEngine::give_states(std::span<const Word> items, std::span<const Word> states) {
  const Header& header = state_.command;
  if ((header.flags & frame::kKeep) != 0) state_.frame->keep(frame::decode_layer(header.arg), items, states);
  if ((header.flags & frame::kQuiet) == 0) give(states);
}

void GoldenEngine::fence(const Header& header) {
  const std::uint32_t slb_sticky = state_.slb ? slb::encode(state_.slb->model().sticky()) : 0;
  const std::uint32_t list_sticky = state_.topology ? topology::encode(state_.topology->lists().sticky()) : 0;
  state_.results.push_back(
      encode(FenceResult{.sticky = state_.sticky | slb_sticky | list_sticky, .tag = header.arg}));
  if ((header.flags & kFenceClearSticky) == 0) return;
  state_.sticky = 0;
  if (state_.slb) state_.slb->model().clear_sticky();
  if (state_.topology) state_.topology->lists().clear_sticky();
}

void GoldenEngine::read_entries(const Header& header) {
  const PlaneRange range = decode_plane_range(header.arg);
  for (std::uint32_t index = range.first; index < range.first + range.count; ++index) {
    const bool present = state_.plane.present(index);
    state_.results.push_back(
        encode(PlaneEntryResult{index, present, present ? state_.plane.depth(index) : 0}));
  }
}

void GoldenEngine::set_registers(std::span<const Word> values) {
  std::uint32_t index = state_.command.arg + state_.items_taken;
  for (const Word value : values) state_.vpu.set(static_cast<Register>(index++), value);
}

void GoldenEngine::project(std::span<const Word> items) {
  std::uint64_t off_plane = 0, saturated = 0, writes = 0;
  cycles::ItemWork work{.items = items.size()};
  if (state_.clock && state_.clock->model.asks_for_items()) work.each.resize(items.size());
  const auto keep = [&](const PlanePoint& point, std::size_t number) {
    if (!point.on_plane) {
      ++off_plane;
      return;
    }
    work.last_updating = number;
    saturated += point.saturated;
    const bool nearer = state_.plane.keep_nearest(state_.vpu.index(point), point.depth);
    if (!work.each.empty())
      work.each[number] = {.line = line_of(point, config_.plane_log2), .updates = true, .writes = nearer};
    if (!nearer) return;
    work.last_writing = number;
    ++writes;
  };
  std::uint64_t behind = 0;
  const bool in_perspective = state_.vpu.in_perspective();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const VoxelItem item = decode_voxel(items[i], config_);
    if (!in_perspective) {
      keep(state_.vpu.land(state_.vpu.accumulate(item)), i);
    } else if (const perspective::Sight sight = state_.vpu.see(item); sight.behind) {
      ++behind;
    } else {
      keep(state_.vpu.land(sight), i);
    }
  }
  if (state_.clock) state_.clock->model.items(work);
  if (behind != 0) state_.sticky |= kStickyBehindLight;
  state_.events.project_behind += behind;
  if (off_plane != 0) state_.sticky |= kStickyOffPlane;
  if (saturated != 0) state_.sticky |= kStickyDepthSaturated;
  state_.events.projected += items.size();
  state_.events.project_off_plane += off_plane;
  state_.events.project_saturated += saturated;
  state_.events.plane_writes += writes;
}

void GoldenEngine::resolve(std::span<const Word> items, bool two_sided) {
  Events& events = state_.events;
  const bool in_perspective = state_.vpu.in_perspective();
  std::vector<Word> states;
  states.reserve(items.size());
  for (const Word word : items) {
    const VoxelItem item = decode_voxel(word, config_);
    const VoxelResult result = in_perspective
                                   ? resolve_perspective(state_.vpu, state_.plane, item, two_sided)
                                   : resolve_orthographic(state_.vpu, state_.plane, item, two_sided);
    events.resolved_behind += result.behind;
    events.resolved_outside_cone += result.outside_cone;
    events.resolved_facing_away += result.facing_away;
    events.resolved_uncertain += result.uncertain;
    events.resolved_offset_empty += result.offset_empty;
    events.resolved_shadow += result.state == VoxelState::Shadow;
    states.push_back(encode(result));
  }
  events.resolved += items.size();
  give_states(items, states);
}

Counters GoldenEngine::counters() const {
  Counters counters{.events = named(state_.events, config_.en_perspective), .cycles = {}};
  if (state_.slb) {
    for (const auto& [name, count] : slb::named(state_.slb->model().counters()))
      counters.events[name] = count;
  }
  if (state_.frame) {
    for (const auto& [name, count] : frame::named(state_.frame->counters())) counters.events[name] = count;
  }
  if (state_.clock) counters.cycles = state_.clock->model.table().named();
  if (state_.topology) {
    for (const auto& [name, count] :
         topology::named(state_.topology->lists().counters(), config_.en_perspective))
      counters.events[name] = count;
  }
  return counters;
}

std::vector<std::uint32_t> GoldenEngine::read_plane() {
  const Plane& plane = state_.plane;
  std::vector<std::uint32_t> depths(plane.size(), kEmpty);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (plane.present(i)) depths[i] = plane.depth(i);
  }
  return depths;
}

}  // namespace

std::unique_ptr<Engine> make_golden_engine(const HardwareConfig& config) {
  return std::make_unique<GoldenEngine>(config, std::nullopt);
}

std::unique_ptr<Engine> make_timed_golden_engine(const HardwareConfig& config, const HardwareTiming& timing) {
  return std::make_unique<GoldenEngine>(config, checked(timing));
}

CycleTable predict_cycles(const HardwareConfig& config, const HardwareTiming& timing,
                          std::span<const Word> words) {
  HardwareTiming job = checked(timing);
  if (job.system) job.system->job_words = words.size();
  GoldenEngine engine(config, job);
  engine.submit(words);
  return engine.predicted();
}

}  // namespace gnomon::golden
