// SPDX-License-Identifier: Apache-2.0
// Words of topology mode's commands and results (docs/vpu-topology.md, "Commands").
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/topology/lists.hpp>
#include <string>

namespace gnomon::golden::topology {

using Word = std::uint64_t;

enum class TopologyOp : std::uint8_t {
  ClearLists = 0x12,
  PutQuads = 0x13,
  ResolveTopology = 0x14,
  ReadLists = 0x15,
};
constexpr bool is_topology_op(std::uint8_t op) {
  return op >= 0x12 && op <= 0x15;
}
inline constexpr std::uint8_t kTwoSided = 0x01, kSorted = 0x02;  ///< flags of ResolveTopology
inline constexpr std::size_t kWordsPerQuad = 4;

/// Flag bits with a meaning.
std::uint8_t known_flags(TopologyOp op);
/// Error 4 of docs/command-stream.md.
bool bad_argument(TopologyOp op, std::uint32_t arg, std::size_t count, const TopologyConfig& config);
/// Of a command without an error.
std::uint32_t result_words(TopologyOp op, std::uint32_t arg, std::size_t count);

/// The argument of ReadLists.
struct EntryRange {
  std::uint32_t first = 0;  ///< 24 bits
  std::uint32_t count = 1;  ///< 1..256
};
std::uint32_t encode(const EntryRange& range);
EntryRange decode_entry_range(std::uint32_t arg);

/// Codes of the mode's result words, bits 63:56.
inline constexpr std::uint8_t kStateCode = 0x14, kListHeadCode = 0x15;

inline constexpr std::uint32_t kStickyDepthSaturated = 1u << 2;
inline constexpr std::uint32_t kStickyListOverflow = 1u << 3;
inline constexpr std::uint32_t kStickyQuadOffPlane = 1u << 4;
inline constexpr std::uint32_t kStickyBehindLight = 1u << 5;
std::uint32_t encode(const TopologySticky& sticky);

/// A voxel item of the command stream: a corner of a quad (its normal is ignored) or a voxel.
struct Item {
  std::array<std::uint32_t, 3> position{};
  std::array<std::int32_t, 3> normal{};
};
Item decode_item(Word word, const TopologyConfig& config);

struct TopologyResult {
  bool shadow = false;
  bool facing_away = false, off_plane = false, uncertain = false, hit = false, fallback = false;
  bool outside_cone = false, behind = false;  ///< the two ways to be unreached; at most one is set
  std::uint32_t quad = kNoQuad;
  std::uint32_t visited = 0, tested = 0;  ///< 0..4095
  bool operator==(const TopologyResult&) const = default;
};
inline constexpr std::uint32_t kMostCounted = 4095;
Word encode(const TopologyResult& result);
TopologyResult decode_topology_result(Word word);

struct ListHeadResult {
  std::uint32_t index = 0;
  ListHead head;
  bool operator==(const ListHeadResult&) const = default;
};
Word encode(const ListHeadResult& result);
ListHeadResult decode_list_head(Word word);

/// One line naming every field of a result word of this mode, for mismatch reports.
std::string describe_topology_result(Word word);

}  // namespace gnomon::golden::topology
