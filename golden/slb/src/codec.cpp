// SPDX-License-Identifier: Apache-2.0
// The only place in C++ that knows the bits of the unit's words.
#include <gnomon/golden/slb/codec.hpp>
#include <stdexcept>

namespace gnomon::golden::slb {
namespace {

/// Appends fields from bit 0 up.
class Packer {
 public:
  Packer& put_unsigned(std::uint64_t value, int width) {
    if (value >> width != 0) throw std::out_of_range("a field of an item does not fit its bits");
    word_ |= value << at_;
    at_ += width;
    return *this;
  }
  Packer& put_signed(std::int64_t value, int width) {
    const std::int64_t limit = std::int64_t{1} << (width - 1);
    if (value < -limit || value >= limit) throw std::out_of_range("a coordinate does not fit its bits");
    return put_unsigned(static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << width) - 1), width);
  }
  Word word() const { return word_; }

 private:
  Word word_ = 0;
  int at_ = 0;
};

class Unpacker {
 public:
  explicit Unpacker(Word word) : word_(word) {}
  std::uint32_t take_unsigned(int width) {
    const Word value = (word_ >> at_) & ((Word{1} << width) - 1);
    at_ += width;
    return static_cast<std::uint32_t>(value);
  }
  std::int64_t take_signed(int width) {
    const std::int64_t value = take_unsigned(width);
    return value >> (width - 1) != 0 ? value - (std::int64_t{1} << width) : value;
  }

 private:
  Word word_;
  int at_ = 0;
};

constexpr int kShadow = 55, kByFull = 54, kByLines = 53, kHasFragment = 52, kOverflow = 51, kOffPlane = 50;
constexpr int kObject = 32, kCode = 56;

bool bit(Word word, int position) {
  return ((word >> position) & 1) != 0;
}
Word flag(bool value, int position) {
  return Word{value} << position;
}

}  // namespace

std::uint32_t encode(const SlbSticky& sticky) {
  return (sticky.line_overflow ? kStickyLineOverflow : 0) |
         (sticky.object_overflow ? kStickyObjectOverflow : 0) |
         (sticky.winding_saturated ? kStickyWindingSaturated : 0);
}

std::optional<std::string> check_items(const SlbConfig& config) {
  const int vertex = 2 * config.vertex_width() + config.depth_bits;
  const int query = 2 * config.query_width() + config.depth_bits;
  if (vertex > 64)
    return "a vertex needs 2 (SLB_PLANE_LOG2 + 2 + SUBPIXEL_BITS) + DEPTH_BITS = " + std::to_string(vertex) +
           " bits, 64 at most";
  if (query > 64)
    return "a query needs 2 (SLB_PLANE_LOG2 + 2 + QUERY_BITS) + DEPTH_BITS = " + std::to_string(query) +
           " bits, 64 at most";
  return std::nullopt;
}

Word encode(const Vertex& vertex, const SlbConfig& config) {
  const int width = config.vertex_width();
  return Packer()
      .put_signed(vertex.x, width)
      .put_signed(vertex.y, width)
      .put_unsigned(vertex.depth, config.depth_bits)
      .word();
}

Vertex decode_vertex(Word word, const SlbConfig& config) {
  Unpacker fields(word);
  Vertex vertex;
  vertex.x = fields.take_signed(config.vertex_width());
  vertex.y = fields.take_signed(config.vertex_width());
  vertex.depth = fields.take_unsigned(config.depth_bits);
  return vertex;
}

Word encode(const QueryPoint& point, const SlbConfig& config) {
  const int width = config.query_width();
  return Packer()
      .put_signed(point.x, width)
      .put_signed(point.y, width)
      .put_unsigned(point.depth, config.depth_bits)
      .word();
}

QueryPoint decode_query(Word word, const SlbConfig& config) {
  Unpacker fields(word);
  QueryPoint point;
  point.x = fields.take_signed(config.query_width());
  point.y = fields.take_signed(config.query_width());
  point.depth = fields.take_unsigned(config.depth_bits);
  return point;
}

Word encode(const CoverSample& sample, const SlbConfig& config) {
  const int width = config.plane_log2 + 2;
  return Packer()
      .put_signed(sample.column, width)
      .put_signed(sample.row, width)
      .put_unsigned(sample.depth, config.depth_bits)
      .put_unsigned(sample.range, kRangeBits)
      .word();
}

CoverSample decode_cover(Word word, const SlbConfig& config) {
  Unpacker fields(word);
  CoverSample sample;
  sample.column = fields.take_signed(config.plane_log2 + 2);
  sample.row = fields.take_signed(config.plane_log2 + 2);
  sample.depth = fields.take_unsigned(config.depth_bits);
  sample.range = fields.take_unsigned(kRangeBits);
  return sample;
}

Word encode(const QueryAnswer& answer, std::uint16_t index) {
  return Word{kAnswerCode} << kCode | flag(answer.shadow, kShadow) | flag(answer.by_full, kByFull) |
         flag(answer.by_lines, kByLines) | flag(answer.has_fragment, kHasFragment) |
         flag(answer.overflow, kOverflow) | flag(answer.off_plane, kOffPlane) |
         Word{answer.object} << kObject | index;
}

QueryAnswer decode_answer(Word word) {
  QueryAnswer answer;
  answer.shadow = bit(word, kShadow);
  answer.by_full = bit(word, kByFull);
  answer.by_lines = bit(word, kByLines);
  answer.has_fragment = bit(word, kHasFragment);
  answer.overflow = bit(word, kOverflow);
  answer.off_plane = bit(word, kOffPlane);
  answer.object = static_cast<std::uint8_t>(word >> kObject);
  return answer;
}

std::uint16_t answer_index(Word word) {
  return static_cast<std::uint16_t>(word);
}

Word encode(const EntryHeader& header) {
  return Word{kEntryCode} << kCode | Word{header.index} << 32 | header.words;
}

EntryHeader decode_entry_header(Word word) {
  return {static_cast<std::uint32_t>(word >> 32) & 0xFFFFFF, static_cast<std::uint8_t>(word)};
}

std::uint32_t encode(const EntryRange& range) {
  return ((range.count - 1) & 0xFF) << 24 | (range.first & 0xFFFFFF);
}

EntryRange decode_entry_range(std::uint32_t arg) {
  return {.first = arg & 0xFFFFFF, .count = (arg >> 24) + 1};
}

}  // namespace gnomon::golden::slb
