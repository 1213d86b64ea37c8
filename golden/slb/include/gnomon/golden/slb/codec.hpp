// SPDX-License-Identifier: Apache-2.0
// Words of the silhouette-line buffer's commands and results (docs/command-stream.md).
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/model.hpp>
#include <string>

namespace gnomon::golden::slb {

using Word = std::uint64_t;

enum class SlbOp : std::uint8_t {
  Clear = 0x20,
  BeginObject = 0x21,
  Loop = 0x22,
  Fill = 0x23,
  Cover = 0x24,
  EndObject = 0x25,
  Query = 0x26,
  ReadEntries = 0x27,
};
inline constexpr std::uint8_t kFirstSlbOp = 0x20, kLastSlbOp = 0x27;
inline constexpr std::uint8_t kBeginFlat = 0x01;  ///< flag of BeginObject
inline constexpr std::uint8_t kLoopMore = 0x01;   ///< flag of Loop

inline constexpr int kRangeBits = 5;  ///< of CoverSample::range

inline constexpr std::uint32_t kStickyLineOverflow = 1u << 8;
inline constexpr std::uint32_t kStickyObjectOverflow = 1u << 9;
inline constexpr std::uint32_t kStickyWindingSaturated = 1u << 10;
std::uint32_t encode(const SlbSticky& sticky);

/// Nothing if items of this configuration fit their words; else one line saying which does not.
std::optional<std::string> check_items(const SlbConfig& config);

Word encode(const Vertex& vertex, const SlbConfig& config);
Vertex decode_vertex(Word word, const SlbConfig& config);
Word encode(const QueryPoint& point, const SlbConfig& config);
QueryPoint decode_query(Word word, const SlbConfig& config);
Word encode(const CoverSample& sample, const SlbConfig& config);
CoverSample decode_cover(Word word, const SlbConfig& config);

/// `index`: of the item in its command.
Word encode(const QueryAnswer& answer, std::uint16_t index);
QueryAnswer decode_answer(Word word);
std::uint16_t answer_index(Word word);

/// Codes of the unit's result words, bits 63:56.
inline constexpr std::uint8_t kAnswerCode = 0x26, kEntryCode = 0x27;

/// The argument of ReadEntries.
struct EntryRange {
  std::uint32_t first = 0;  ///< row-major, 24 bits
  std::uint32_t count = 1;  ///< 1..256
};
std::uint32_t encode(const EntryRange& range);
EntryRange decode_entry_range(std::uint32_t arg);

/// The word before an entry's raw words.
struct EntryHeader {
  std::uint32_t index = 0;
  std::uint8_t words = 0;
  bool operator==(const EntryHeader&) const = default;
};
Word encode(const EntryHeader& header);
EntryHeader decode_entry_header(Word word);

/// One line naming every field, for mismatch reports. No two words read the same.
std::string describe_answer(Word word);
std::string describe_entry_header(Word word);
/// Raw word `index` of an entry: the fields that lie in it, wholly or in part.
std::string describe_entry_word(Word word, int index, const SlbConfig& config);
std::string describe(const Line& line);
std::string describe(const Entry& entry);

}  // namespace gnomon::golden::slb
