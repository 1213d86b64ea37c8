// SPDX-License-Identifier: Apache-2.0
// What the golden engine holds between words.
#pragma once

#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/cycles.hpp>
#include <gnomon/golden/frame/unit.hpp>
#include <gnomon/golden/slb/unit.hpp>
#include <gnomon/golden/topology/unit.hpp>
#include <gnomon/golden/vpu.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cycles/cycle_model.hpp"
#include "plane.hpp"

namespace gnomon::golden {

/// Event counters (docs/command-stream.md).
struct Events {
  std::uint64_t commands = 0, errors = 0;
  std::uint64_t projected = 0, project_off_plane = 0, project_saturated = 0, plane_writes = 0;
  std::uint64_t resolved = 0, resolved_facing_away = 0, resolved_uncertain = 0, resolved_offset_empty = 0,
                resolved_shadow = 0;
  // With EN_PERSPECTIVE.
  std::uint64_t project_behind = 0, resolved_behind = 0, resolved_outside_cone = 0;
};

/// With their names; those of the perspective projection only on request.
inline std::map<std::string, std::uint64_t> named(const Events& events, bool perspective) {
  std::map<std::string, std::uint64_t> counts{{"COMMANDS", events.commands},
                                              {"ERRORS", events.errors},
                                              {"VOXELS_PROJECTED", events.projected},
                                              {"PROJECT_OFF_PLANE", events.project_off_plane},
                                              {"PROJECT_SATURATED", events.project_saturated},
                                              {"PLANE_WRITES", events.plane_writes},
                                              {"VOXELS_RESOLVED", events.resolved},
                                              {"RESOLVED_FACING_AWAY", events.resolved_facing_away},
                                              {"RESOLVED_UNCERTAIN", events.resolved_uncertain},
                                              {"RESOLVED_OFFSET_EMPTY", events.resolved_offset_empty},
                                              {"RESOLVED_SHADOW", events.resolved_shadow}};
  if (perspective) {
    counts["PROJECT_BEHIND"] = events.project_behind;
    counts["RESOLVED_BEHIND"] = events.resolved_behind;
    counts["RESOLVED_OUTSIDE_CONE"] = events.resolved_outside_cone;
  }
  return counts;
}

/// What cycles are predicted from.
struct Clock {
  Clock(const HardwareConfig& config, const HardwareTiming& timing) : model(config, timing) {}

  cycles::CycleModel model;
  slb::FillSweep fill;       ///< the last one
  topology::ListWork lists;  ///< of the items at hand
};

/// Everything that a reset brings back to its first value.
struct State {
  State(const HardwareConfig& config, const std::optional<HardwareTiming>& timing)
      : vpu(config),
        plane(static_cast<std::size_t>(config.plane_side()) * static_cast<std::size_t>(config.plane_side())),
        topology(config.en_vpu_topology ? std::make_unique<topology::TopologyUnit>(config.topology_config())
                                        : nullptr),
        frame(config.en_frame_buffer ? std::make_unique<frame::FrameUnit>(config.frame_config()) : nullptr),
        slb(config.en_slb ? std::make_unique<slb::SlbUnit>(config.slb_config()) : nullptr),
        sequence(config),
        clock(timing ? std::make_unique<Clock>(config, *timing) : nullptr) {
    if (slb && clock) slb->model().watch_fill(&clock->fill);
    if (topology && clock) topology->lists().watch(&clock->lists);
  }

  Vpu vpu;
  Plane plane;
  std::unique_ptr<topology::TopologyUnit> topology;  ///< only with EN_VPU_TOPOLOGY
  std::unique_ptr<frame::FrameUnit> frame;           ///< only with EN_FRAME_BUFFER
  std::unique_ptr<slb::SlbUnit> slb;                 ///< only with EN_SLB
  CommandSequence sequence;
  std::unique_ptr<Clock> clock;  ///< only of the timed engine
  Events events;
  std::uint32_t sticky = 0;
  Header command;             ///< the command in progress
  bool ignore_items = false;  ///< it is a NOP or in error
  std::uint32_t items_taken = 0;
  std::vector<Word> results;

  bool between_commands() const { return items_taken == command.count; }
};

}  // namespace gnomon::golden
