// SPDX-License-Identifier: Apache-2.0
// Bit layout of lines and entries.
#include <gnomon/golden/slb/formats.hpp>
#include <stdexcept>

namespace gnomon::golden::slb {
namespace {

/// Appends fields, lowest bits first.
class BitWriter {
 public:
  explicit BitWriter(int bits) : words_(static_cast<std::size_t>(bits) / 64, 0) {}
  void put(std::uint64_t value, int width) {
    for (int bit = 0; bit < width; ++bit, ++at_) words_.at(at_ / 64) |= ((value >> bit) & 1) << (at_ % 64);
  }
  std::vector<std::uint64_t> words() const { return words_; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t at_ = 0;
};

class BitReader {
 public:
  explicit BitReader(const std::vector<std::uint64_t>& words) : words_(words) {}
  std::uint32_t take(int width) {
    std::uint32_t value = 0;
    for (int bit = 0; bit < width; ++bit, ++at_)
      value |= static_cast<std::uint32_t>((words_.at(at_ / 64) >> (at_ % 64)) & 1) << bit;
    return value;
  }

 private:
  const std::vector<std::uint64_t>& words_;
  std::size_t at_ = 0;
};

}  // namespace

int Entry::last_group() const {
  int first = count;
  while (first > 0) {
    --first;
    if (!fragments[static_cast<std::size_t>(first)].cont) break;
  }
  return first;
}

int Entry::chains(int first, int last) const {
  int sum = 0;
  for (int i = first; i < last; ++i) sum += fragments[static_cast<std::size_t>(i)].chains();
  return sum;
}

std::uint32_t pack(const Line& line, const SlbConfig& config) {
  std::uint32_t bits = line.major ? 1 : 0;
  bits = bits << 1 | (line.xsign ? 1u : 0u);
  bits = bits << 1 | (line.cross ? 1u : 0u);
  bits = bits << 1 | (line.inner ? 1u : 0u);
  bits = bits << config.frac_bits | line.frac;
  return bits << config.slope_bits | line.slope;
}

Line unpack_line(std::uint32_t bits, const SlbConfig& config) {
  Line line;
  line.slope = static_cast<std::uint16_t>(bits & static_cast<std::uint32_t>(config.d1()));
  bits >>= config.slope_bits;
  line.frac = static_cast<std::uint16_t>(bits & static_cast<std::uint32_t>(config.d0()));
  bits >>= config.frac_bits;
  line.inner = (bits & 1) != 0;
  line.cross = (bits & 2) != 0;
  line.xsign = (bits & 4) != 0;
  line.major = (bits & 8) != 0;
  return line;
}

std::vector<std::uint64_t> pack(const Entry& entry, const SlbConfig& config) {
  BitWriter bits(config.stored_entry_bits());
  bits.put(0, kGenerationBits);
  bits.put(entry.count, config.count_bits());
  bits.put(entry.overflow ? 1 : 0, 1);
  bits.put(entry.open ? 1 : 0, 1);
  bits.put(static_cast<std::uint64_t>(entry.corner), kCornerBits);
  bits.put(entry.full_depth, config.depth_bits);
  for (int i = 0; i < entry.count; ++i) {
    const Fragment& fragment = entry.fragments[static_cast<std::size_t>(i)];
    bits.put(fragment.depth, config.depth_bits);
    bits.put(fragment.object, 8);
    bits.put(static_cast<std::uint64_t>(fragment.op), 2);
    bits.put(pack(fragment.a, config), config.line_bits());
    bits.put(fragment.op == FragmentOp::One ? 0 : pack(fragment.b, config), config.line_bits());
    bits.put(fragment.threshold_m1, config.threshold_bits());
    bits.put(fragment.cont ? 1 : 0, 1);
  }
  return bits.words();
}

Entry unpack_entry(const std::vector<std::uint64_t>& words, const SlbConfig& config) {
  if (words.size() * 64 != static_cast<std::size_t>(config.stored_entry_bits()))
    throw std::invalid_argument("an entry has " + std::to_string(config.stored_entry_bits() / 64) +
                                " words, not " + std::to_string(words.size()));
  BitReader bits(words);
  Entry entry;
  entry.generation = static_cast<std::uint8_t>(bits.take(kGenerationBits));
  entry.count = static_cast<std::uint8_t>(bits.take(config.count_bits()));
  entry.overflow = bits.take(1) != 0;
  entry.open = bits.take(1) != 0;
  const auto corner = static_cast<int>(bits.take(kCornerBits));
  entry.corner = static_cast<std::int8_t>(corner > kCornerMax ? corner + 2 * kCornerMin : corner);
  entry.full_depth = bits.take(config.depth_bits);
  if (entry.count > config.frags) throw std::invalid_argument("an entry with more fragments than it holds");
  for (int i = 0; i < entry.count; ++i) {
    Fragment& fragment = entry.fragments[static_cast<std::size_t>(i)];
    fragment.depth = bits.take(config.depth_bits);
    fragment.object = static_cast<std::uint8_t>(bits.take(8));
    fragment.op = static_cast<FragmentOp>(bits.take(2));
    fragment.a = unpack_line(bits.take(config.line_bits()), config);
    fragment.b = unpack_line(bits.take(config.line_bits()), config);
    fragment.threshold_m1 = static_cast<std::uint8_t>(bits.take(config.threshold_bits()));
    fragment.cont = bits.take(1) != 0;
  }
  return entry;
}

}  // namespace gnomon::golden::slb
