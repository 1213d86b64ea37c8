// SPDX-License-Identifier: Apache-2.0
// Words and records of the unit as one line of text.
#include <algorithm>
#include <gnomon/golden/slb/codec.hpp>

namespace gnomon::golden::slb {
namespace {

std::string named(const char* name, std::int64_t value) {
  return std::string(" ") + name + "=" + std::to_string(value);
}

std::string hex(Word value) {
  static constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text = "0x";
  for (int at = 60; at >= 0; at -= 4) text += kDigits[value >> at & 15];
  return text;
}

/// Bits that must be zero.
std::string reserved(Word word, Word canonical) {
  return word == canonical ? "" : " reserved=" + hex(word ^ canonical);
}

/// Walks the fields of an entry, and keeps the text of those that lie in one of its words.
class FieldsOfWord {
 public:
  FieldsOfWord(Word word, int index)
      : word_(word), from_(64 * index), text_("entry word " + std::to_string(index)) {}

  void field(const std::string& name, int width) {
    const int low = std::max(at_, from_);
    const int high = std::min(at_ + width, from_ + 64);
    if (low < high) {
      const Word value = word_ >> (low - from_) & ones(high - low);
      text_ += ' ';
      text_ += name;
      if (high - low < width) add_range(high - 1 - at_, low - at_);
      text_ += '=';
      text_ += std::to_string(value);
    }
    at_ += width;
  }
  void line(const std::string& name, const SlbConfig& config) {
    field(name + ".slope", config.slope_bits);
    field(name + ".frac", config.frac_bits);
    for (const char* flag : {".inner", ".cross", ".xsign", ".major"}) field(name + flag, 1);
  }
  void padding() {
    const Word rest = word_ & ~ones(std::clamp(at_ - from_, 0, 64));
    if (rest == 0) return;
    text_ += " padding=";
    text_ += hex(rest);
  }
  const std::string& text() const { return text_; }

 private:
  static Word ones(int width) { return width == 64 ? ~Word{0} : (Word{1} << width) - 1; }
  void add_range(int high, int low) {
    text_ += '[';
    text_ += std::to_string(high);
    text_ += ':';
    text_ += std::to_string(low);
    text_ += ']';
  }

  Word word_;
  int from_, at_ = 0;
  std::string text_;
};

}  // namespace

std::string describe_answer(Word word) {
  const QueryAnswer a = decode_answer(word);
  return "SLB_ANSWER" + named("item", answer_index(word)) + named("shadow", a.shadow) +
         named("by_full", a.by_full) + named("by_lines", a.by_lines) + named("has_fragment", a.has_fragment) +
         named("overflow", a.overflow) + named("off_plane", a.off_plane) + named("object", a.object) +
         reserved(word, encode(a, answer_index(word)));
}

std::string describe_entry_header(Word word) {
  const EntryHeader header = decode_entry_header(word);
  return "SLB_ENTRY" + named("index", header.index) + named("words", header.words) +
         reserved(word, encode(header));
}

std::string describe_entry_word(Word word, int index, const SlbConfig& config) {
  FieldsOfWord fields(word, index);
  fields.field("generation", kGenerationBits);
  fields.field("count", config.count_bits());
  fields.field("overflow", 1);
  fields.field("open", 1);
  fields.field("corner", kCornerBits);
  fields.field("full_depth", config.depth_bits);
  for (int i = 0; i < config.frags; ++i) {
    std::string fragment = "f";
    fragment += std::to_string(i);
    fields.field(fragment + ".depth", config.depth_bits);
    fields.field(fragment + ".object", 8);
    fields.field(fragment + ".op", 2);
    fields.line(fragment + ".a", config);
    fields.line(fragment + ".b", config);
    fields.field(fragment + ".threshold", config.threshold_bits());
    fields.field(fragment + ".cont", 1);
  }
  fields.padding();
  return fields.text();
}

std::string describe(const Line& line) {
  return std::string(line.major ? "y-major" : "x-major") + (line.xsign ? " falling" : " rising") +
         named("cross", line.cross) + named("inner", line.inner) + named("frac", line.frac) +
         named("slope", line.slope);
}

std::string describe(const Entry& entry) {
  std::string text = "entry" + named("count", entry.count) + named("overflow", entry.overflow) +
                     named("full_depth", entry.full_depth);
  for (int i = 0; i < entry.count; ++i) {
    const Fragment& fragment = entry.fragments[static_cast<std::size_t>(i)];
    static constexpr const char* kOps[] = {"one", "and", "or", "two"};
    text += "; " + std::string(kOps[static_cast<std::size_t>(fragment.op)]) + named("depth", fragment.depth) +
            named("object", fragment.object) + named("T", fragment.threshold_m1 + 1) +
            named("cont", fragment.cont) + " A{" + describe(fragment.a) + "}";
    if (fragment.op != FragmentOp::One) text += " B{" + describe(fragment.b) + "}";
  }
  return text;
}

}  // namespace gnomon::golden::slb
