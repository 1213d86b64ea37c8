// SPDX-License-Identifier: Apache-2.0
// Which counter of gnomon_core has which name (docs/command-stream.md).
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

/// Event counters of the silhouette-line buffer: index kFirstSlbCounter + number here; 0 in hardware without.
inline constexpr std::uint32_t kFirstSlbCounter = 16;
inline constexpr std::array<std::string_view, 23> kSlbEventNames{"SLB_OBJECTS",
                                                                 "SLB_LOOPS",
                                                                 "SLB_LOOPS_SHORT",
                                                                 "SLB_LOOPS_TINY",
                                                                 "SLB_TINY_AREA2",
                                                                 "SLB_VERTICES",
                                                                 "SLB_VERTICES_REPEATED",
                                                                 "SLB_CROSSINGS",
                                                                 "SLB_CHAINS",
                                                                 "SLB_CHAINS_OFF_PLANE",
                                                                 "SLB_CHAINS_DROPPED",
                                                                 "SLB_CHAINS_REDUCED",
                                                                 "SLB_GROUPS_EVICTED",
                                                                 "SLB_WINDING_SATURATED",
                                                                 "SLB_FILL_PIXELS",
                                                                 "SLB_FILL_GROUPS",
                                                                 "SLB_FILL_COVERED",
                                                                 "SLB_COVERS",
                                                                 "SLB_COVERS_USED",
                                                                 "SLB_QUERIES",
                                                                 "SLB_QUERIES_SHADOW",
                                                                 "SLB_QUERIES_OFF_PLANE",
                                                                 "SLB_QUERIES_OVERFLOW"};

/// Event counters of topology mode: index kFirstTopologyCounter + number here; 0 in hardware without.
inline constexpr std::uint32_t kFirstTopologyCounter = 40;
inline constexpr std::array<std::string_view, 15> kTopologyEventNames{
    "QUADS_PUT",     "QUADS_OFF_PLANE",   "QUADS_TOO_LARGE",      "QUADS_SATURATED",    "NODES_LINKED",
    "NODES_DROPPED", "TOPOLOGY_RESOLVED", "TOPOLOGY_FACING_AWAY", "TOPOLOGY_OFF_PLANE", "TOPOLOGY_UNCERTAIN",
    "TOPOLOGY_HIT",  "TOPOLOGY_FALLBACK", "TOPOLOGY_SHADOW",      "NODES_VISITED",      "QUADS_TESTED"};

/// Event counters of the perspective projection: index kFirstPerspectiveCounter + number here; 0 in hardware
/// without. The last four belong to topology mode too.
inline constexpr std::uint32_t kFirstPerspectiveCounter = 55;
inline constexpr std::array<std::string_view, 7> kPerspectiveEventNames{
    "PROJECT_BEHIND",   "RESOLVED_BEHIND", "RESOLVED_OUTSIDE_CONE", "QUADS_BEHIND",
    "QUADS_STRADDLING", "TOPOLOGY_BEHIND", "TOPOLOGY_OUTSIDE_CONE"};
inline constexpr std::size_t kPerspectiveOffsetEvents = 3;  ///< of these, in hardware without topology mode

/// Event counters of the frame buffer: index kFirstFrameCounter + number here; 0 in hardware without.
inline constexpr std::uint32_t kFirstFrameCounter = 128;
inline constexpr std::array<std::string_view, 5> kFrameEventNames{
    "FRAME_KEPT", "FRAME_OVERWRITTEN", "FRAME_LOOKUPS", "FRAME_LOOKUPS_EMPTY", "FRAME_BRICKS"};

/// Counters of the caches (docs/cache.md), eight places for each memory; 0 in hardware without. Not events of
/// the stream: other memories give others.
inline constexpr std::uint32_t kFirstCacheCounter = 136;
inline constexpr std::array<std::string_view, 6> kCacheMemoryNames{"PLANE", "LANES", "FRAGMENTS",
                                                                   "HEADS", "NODES", "RECORDS"};
enum class CacheEvent : std::uint8_t { Hits, HitsBeside, Misses, Fills, WriteBacks, Waits };
inline constexpr std::array<std::string_view, 6> kCacheEventNames{"HITS",  "HITS_BESIDE", "MISSES",
                                                                  "FILLS", "WRITE_BACKS", "FILL_WAITS"};
inline std::string cache_counter_name(std::size_t memory, std::size_t event) {
  return "CACHE_" + std::string(kCacheMemoryNames[memory]) + "_" + std::string(kCacheEventNames[event]);
}
inline std::uint32_t cache_counter_index(std::size_t memory, CacheEvent event) {
  return kFirstCacheCounter + 8 * static_cast<std::uint32_t>(memory) + static_cast<std::uint32_t>(event);
}

/// Cycle counters: index kFirstCycleCounter + kCauses * pass + cause.
inline constexpr std::uint32_t kFirstCycleCounter = 64;
inline constexpr std::array<std::string_view, 10> kPassNames{"IDLE", "CONTROL", "CLEAR", "PROJECT", "RESOLVE",
                                                             "READ", "DRAW",    "FILL",  "COVER",   "QUERY"};
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
