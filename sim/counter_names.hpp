// SPDX-License-Identifier: Apache-2.0
// Which counter of gnomon_top has which name (docs/command-stream.md).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gnomon::sim {

/// Event counters, by index.
inline constexpr std::array<std::string_view, 11> kEventNames{"COMMANDS",           "ERRORS",
                                                              "VOXELS_PROJECTED",   "PROJECT_OFF_PLANE",
                                                              "PROJECT_SATURATED",  "PLANE_WRITES",
                                                              "VOXELS_RESOLVED",    "RESOLVED_FACING_AWAY",
                                                              "RESOLVED_UNCERTAIN", "RESOLVED_OFFSET_EMPTY",
                                                              "RESOLVED_SHADOW"};
inline constexpr std::uint32_t kStickyCounter = 11;

/// Cycle counters: index kFirstCycleCounter + kCauses * pass + cause.
inline constexpr std::uint32_t kFirstCycleCounter = 16;
inline constexpr std::array<std::string_view, 6> kPassNames{"IDLE",    "CONTROL", "CLEAR",
                                                            "PROJECT", "RESOLVE", "READ"};
inline constexpr std::array<std::string_view, 6> kCauseNames{"BUSY",        "INPUT_STARVED", "OUTPUT_BLOCKED",
                                                             "MEMORY_WAIT", "HAZARD",        "IDLE"};

/// Key of golden::Counters::cycles.
inline std::string cycle_counter_name(std::size_t pass, std::size_t cause) {
  return "cycles." + std::string(kPassNames[pass]) + "." + std::string(kCauseNames[cause]);
}
inline std::uint32_t cycle_counter_index(std::size_t pass, std::size_t cause) {
  return kFirstCycleCounter + static_cast<std::uint32_t>(pass * kCauseNames.size() + cause);
}

}  // namespace gnomon::sim
