// SPDX-License-Identifier: Apache-2.0
// The faults that rtl/mutations_pkg.sv can build in, by the test that notices them. A new fault goes into the
// list that its test runs through; a new list also goes into kFaultLists, where tests/sim/mutation_test.cpp
// compares all of them with what the RTL offers.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace gnomon::stimulus {

/// Each a build of its own, with GNOMON_MUTATE_<name> defined: tests/sim/mutation_test.cpp.
inline constexpr std::array<std::string_view, 8> kBuiltInFaults{
    "TIES_REPLACE", "NO_FORWARDING",   "ROUND_DEPTH",  "MARGIN_OR_EQUAL",
    "LOSE_STICKY",  "KEEP_GENERATION", "SKIP_BARRIER", "SKID_OVERRUN"};

/// The silhouette-line buffer's front end, one build with all of them: tests/rtl/slb/outline.
inline constexpr std::array<std::string_view, 10> kSlbOutlineFaults{
    "SLB_NO_ADJUST",    "SLB_DRIFT",         "SLB_DEPTH_DRIFT", "SLB_FORGET_KEPT",     "SLB_FORGET_ASIDE",
    "SLB_EXACT_ALWAYS", "SLB_LAST_OF_EQUAL", "SLB_NO_SPIKES",   "SLB_CORNER_BY_SIDES", "SLB_COUNT_CLOSE"};

/// Its back end and what it shares with the projection unit, one build with all of them: tests/rtl/slb.
inline constexpr std::array<std::string_view, 16> kSlbFaults{
    "SLB_EVICT_EARLIER",   "SLB_FORGET_CENTRE", "SLB_KEEP_CORNER",    "SLB_FIRST_LINE",
    "SLB_WRAP_WINDING",    "SLB_LOSE_CARRY",    "SLB_FORGET_PLAIN",   "SLB_PLAIN_BEFORE",
    "SLB_ENTRY_ALONE",     "SLB_KEEP_LINES",    "SLB_COVER_ALL_ROWS", "SLB_LAST_OBJECT",
    "SLB_OPEN_HALF_PLANE", "NO_FORWARDING",     "KEEP_GENERATION",    "SKIP_BARRIER"};

/// Topology mode and the perspective projection, one build with all of them: tests/rtl/perspective.
inline constexpr std::array<std::string_view, 15> kProjectionFaults{
    "TOPOLOGY_KEEP_HEAD",        "TOPOLOGY_NEAR_LAST",       "TOPOLOGY_CLIP_SHORT",
    "TOPOLOGY_NO_EARLY_EXIT",    "TOPOLOGY_LOSE_DROPPED",    "TOPOLOGY_OPEN_SIDES",
    "TOPOLOGY_SORTED_GOES_ON",   "PERSPECTIVE_NO_STEP",      "PERSPECTIVE_NEAR_OR_EQUAL",
    "PERSPECTIVE_NO_TURN",       "PERSPECTIVE_CONE_ALWAYS",  "PERSPECTIVE_KEEP_STRADDLING",
    "PERSPECTIVE_FACE_THE_AXIS", "PERSPECTIVE_NO_CLEARANCE", "PERSPECTIVE_PLAIN_MAX"};

/// The frame buffer's and one of the memory below it, each a build of its own:
/// tests/sim/frame_cosim_test.cpp.
inline constexpr std::array<std::string_view, 5> kFrameFaults{
    "FRAME_FIRST_STATE", "FRAME_KEEP_AGAIN", "FRAME_LAYER_ZERO", "FRAME_SHARE_WORDS", "NO_FORWARDING"};

/// The caches before planes and lists in memory, one build with all of them: tests/rtl/cache.
inline constexpr std::array<std::string_view, 4> kCacheFaults{"CACHE_LOSE_WRITE_BACK", "CACHE_FETCH_EARLY",
                                                              "CACHE_KEEP_TOUCHED", "NO_FORWARDING"};

/// What is around the core, one build with all of them: tests/rtl/system.
inline constexpr std::array<std::string_view, 9> kSystemFaults{
    "AXI_WITHDRAW",      "AXI_CHANGE_ADDRESS", "AXI_LAST_EARLY", "AXI_CROSS_PAGES",    "AXI_FIXED_BURST",
    "AXI_IGNORE_ERRORS", "AXI_FORGET_EPOCH",   "AXI_NO_TIMEOUT", "RESULTS_COUNT_EARLY"};

/// All of them. A fault may stand in several.
inline constexpr std::array<std::span<const std::string_view>, 7> kFaultLists{
    kBuiltInFaults, kSlbOutlineFaults, kSlbFaults,   kProjectionFaults,
    kFrameFaults,   kCacheFaults,      kSystemFaults};

}  // namespace gnomon::stimulus
