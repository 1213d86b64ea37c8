// SPDX-License-Identifier: Apache-2.0
#include "slb_streams.hpp"

#include <algorithm>
#include <gnomon/golden/codec.hpp>
#include <utility>

#include "tests/golden/slb/stimulus.hpp"

namespace gnomon::rtl_test {

using golden::HardwareConfig;
using golden::Word;
using golden::slb::SlbConfig;
using golden::slb::SlbOp;
namespace slb_stimulus = golden::slb::testing;

namespace {

void append(std::vector<Word>& words, const std::vector<Word>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// Sticky flags, then every entry.
void append_dump(std::vector<Word>& words, const SlbConfig& config) {
  words.push_back(encode(golden::Header{static_cast<std::uint8_t>(golden::Op::Fence), 1, 0, 0x5AB}));
  const auto entries = static_cast<std::uint32_t>(config.side()) * static_cast<std::uint32_t>(config.side());
  for (std::uint32_t first = 0; first < entries; first += 256) {
    const std::uint32_t count = std::min(entries - first, 256u);
    append(words, slb_command(SlbOp::ReadEntries, 0, (count - 1) << 24 | first, {}));
  }
}

class Crowd {
 public:
  Crowd(std::uint64_t seed, const SlbConfig& config) : random_(seed), config_(config) {}

  std::vector<Word> stream() {
    for (int object = 0; object < 40; ++object) draw(static_cast<std::uint8_t>(object));
    for (int command = 0; command < 3; ++command) query();
    append_dump(words_, config_);
    return std::move(words_);
  }

 private:
  std::uint32_t depth() {
    return static_cast<std::uint32_t>(random_.integer(3, 9)) * (config_.no_depth() / 12);
  }

  /// A polygon over a few of the pixels in the plane's middle.
  std::vector<Word> loop() {
    const double middle = config_.side() / 2.0;
    const slb_stimulus::Point centre{middle + random_.between(-1.5, 1.5),
                                     middle + random_.between(-1.5, 1.5)};
    const int corners = static_cast<int>(random_.integer(3, 9));
    std::vector<Word> items;
    const auto polygon = slb_stimulus::star(random_, corners, 0.3, 2.0, centre);
    for (const auto& vertex : slb_stimulus::quantise(polygon, config_, depth())) {
      items.push_back(encode(vertex, config_));
    }
    return items;
  }

  void draw(std::uint8_t object) {
    const bool flat = random_.integer(0, 2) != 0;
    append(words_, slb_command(SlbOp::BeginObject, flat ? golden::slb::kBeginFlat : 0,
                               std::uint32_t{object} << 24 | depth(), {}));
    for (std::int64_t loops = random_.integer(1, 3); loops > 0; --loops) {
      append(words_, slb_command(SlbOp::Loop, 0, 0, loop()));
    }
    append(words_, slb_command(SlbOp::Fill, 0, 0, {}));
    if (!flat) cover();
    append(words_, slb_command(SlbOp::EndObject, 0, 0, {}));
  }

  /// Two samples in every pixel near the middle, neighbours and the same pixel one after the other.
  void cover() {
    std::vector<Word> items;
    const int middle = config_.side() / 2;
    for (int sample = 0; sample < 98; ++sample) {
      const int pixel = sample / 2;
      items.push_back(encode(golden::slb::CoverSample{middle - 3 + pixel % 7, middle - 3 + pixel / 7, depth(),
                                                      static_cast<std::uint32_t>(random_.integer(0, 31))},
                             config_));
    }
    append(words_, slb_command(SlbOp::Cover, 0, static_cast<std::uint32_t>(random_.integer(0, 3)), items));
  }

  void query() {
    std::vector<Word> items;
    const std::int64_t middle = std::int64_t{config_.side()} << (config_.query_bits - 1);
    const std::int64_t reach = std::int64_t{4} << config_.query_bits;
    items.reserve(500);
    for (int point = 0; point < 500; ++point) {
      items.push_back(encode(golden::slb::QueryPoint{middle + random_.integer(-reach, reach),
                                                     middle + random_.integer(-reach, reach), depth()},
                             config_));
    }
    append(words_, slb_command(SlbOp::Query, 0, static_cast<std::uint32_t>(random_.integer(0, 3)), items));
  }

  slb_stimulus::Random random_;
  SlbConfig config_;
  std::vector<Word> words_;
};

/// Objects with wide insides and outsides, also beyond the plane, and a sample in every pixel after each.
class Wide {
 public:
  Wide(std::uint64_t seed, const SlbConfig& config) : random_(seed), config_(config) {}

  std::vector<Word> stream() {
    for (int object = 0; object < 5; ++object) draw(object);
    append_dump(words_, config_);
    return std::move(words_);
  }

 private:
  std::uint32_t depth() {
    return static_cast<std::uint32_t>(random_.integer(3, 9)) * (config_.no_depth() / 12);
  }

  /// A star about any point; its outline may lie wholly outside of the plane, to its left or around it.
  void loop(bool hole) {
    const double side = config_.side(), radius = random_.between(0.1, 0.7) * side;
    const slb_stimulus::Point centre{random_.between(-0.5, 1.2) * side, random_.between(0, side)};
    auto polygon =
        slb_stimulus::star(random_, static_cast<int>(random_.integer(3, 9)), 0.4 * radius, radius, centre);
    if (hole) std::reverse(polygon.begin(), polygon.end());
    std::vector<Word> items;
    for (const auto& vertex : slb_stimulus::quantise(polygon, config_, depth()))
      items.push_back(encode(vertex, config_));
    append(words_, slb_command(SlbOp::Loop, 0, 0, items));
  }

  void draw(int object) {
    const bool flat = object % 2 == 1;
    append(words_, slb_command(SlbOp::BeginObject, flat ? golden::slb::kBeginFlat : 0,
                               static_cast<std::uint32_t>(object) << 24 | depth(), {}));
    for (std::int64_t loops = random_.integer(1, 4); loops > 0; --loops) loop(random_.integer(0, 3) == 0);
    append(words_, slb_command(SlbOp::Fill, 0, 0, {}));
    for (int row = 0; row < config_.side(); ++row) {
      std::vector<Word> samples;
      samples.reserve(static_cast<std::size_t>(config_.side()));
      for (int column = 0; column < config_.side(); ++column)
        samples.push_back(encode(golden::slb::CoverSample{column, row, depth(), 3}, config_));
      append(words_, slb_command(SlbOp::Cover, 0, 0, samples));
    }
    append(words_, slb_command(SlbOp::EndObject, 0, 0, {}));
  }

  slb_stimulus::Random random_;
  SlbConfig config_;
  std::vector<Word> words_;
};

}  // namespace

std::vector<Word> slb_command(SlbOp op, std::uint8_t flags, std::uint32_t arg,
                              const std::vector<Word>& items) {
  std::vector<Word> words{encode(
      golden::Header{static_cast<std::uint8_t>(op), flags, static_cast<std::uint16_t>(items.size()), arg})};
  append(words, items);
  return words;
}

std::vector<Word> random_slb_stream(std::uint64_t seed, const HardwareConfig& config) {
  std::vector<Word> words =
      slb_stimulus::to_words(slb_stimulus::random_commands(seed, config.slb_config(), {.read_back = false}));
  append_dump(words, config.slb_config());
  return words;
}

std::vector<Word> piled_slb_stream(std::uint64_t seed, const HardwareConfig& hardware) {
  const SlbConfig config = hardware.slb_config();
  const double side = config.side();
  slb_stimulus::Polygon polygon{
      {-1.5, 0.5}, {side - 1.5, 0.75}, {side - 2.25, side - 1.25}, {-0.75, side - 0.25}};
  if (seed % 2 == 0) std::reverse(polygon.begin(), polygon.end());
  std::vector<Word> items;
  for (const auto& vertex : slb_stimulus::quantise(polygon, config, 5))
    items.push_back(encode(vertex, config));

  std::vector<Word> words = slb_command(SlbOp::BeginObject, golden::slb::kBeginFlat, 7u << 24 | 5, {});
  for (int i = 0; i < 150; ++i) append(words, slb_command(SlbOp::Loop, 0, 0, items));
  append(words, slb_command(SlbOp::Fill, 0, 0, {}));
  append(words, slb_command(SlbOp::EndObject, 0, 0, {}));
  append_dump(words, config);
  return words;
}

std::vector<Word> diagonal_slb_stream(const HardwareConfig& hardware) {
  const SlbConfig config = hardware.slb_config();
  const std::int64_t middle = config.side() / 2, reach = middle - 1;
  std::vector<Word> corners, points;
  for (const auto& [x, y] : {std::pair{middle, middle - reach}, std::pair{middle + reach, middle},
                             std::pair{middle, middle + reach}, std::pair{middle - reach, middle}}) {
    corners.push_back(
        encode(golden::slb::Vertex{x << config.subpixel_bits, y << config.subpixel_bits, 0}, config));
  }
  // Read at + 1/2: a point and its mirror image 1 - x lie as far from their pixel's sides.
  const auto one = std::int64_t{1} << config.query_bits;
  for (std::int64_t i = 0; i < reach; ++i) {
    for (const std::int64_t at : {std::int64_t{0}, one / 3, one - 1}) {
      for (const std::int64_t y : {middle - reach + i, middle + reach - 1 - i}) {
        const std::int64_t right = y < middle ? at : one - 1 - at;
        points.push_back(
            encode(golden::slb::QueryPoint{(middle + i) * one + right, y * one + at, 9}, config));
        points.push_back(encode(
            golden::slb::QueryPoint{(middle - 1 - i) * one + one - 1 - right, y * one + at, 9}, config));
      }
    }
  }
  std::vector<Word> words = slb_command(SlbOp::BeginObject, golden::slb::kBeginFlat, 7u << 24 | 5, {});
  append(words, slb_command(SlbOp::Loop, 0, 0, corners));
  append(words, slb_command(SlbOp::Fill, 0, 0, {}));
  append(words, slb_command(SlbOp::EndObject, 0, 0, {}));
  append(words, slb_command(SlbOp::Query, 0, 0, points));
  append_dump(words, config);
  return words;
}

std::vector<Word> clearing_slb_stream(const HardwareConfig& config) {
  std::vector<Word> words = piled_slb_stream(1, config);
  for (int clears = 1; clears <= 256; ++clears) {
    append(words, slb_command(SlbOp::Clear, 0, 0, {}));
    if (clears == 1 || clears >= 254) append_dump(words, config.slb_config());
  }
  return words;
}

std::vector<Word> wide_slb_stream(std::uint64_t seed, const HardwareConfig& config) {
  return Wide(seed, config.slb_config()).stream();
}

std::vector<Word> crowded_slb_stream(std::uint64_t seed, const HardwareConfig& config) {
  return Crowd(seed, config.slb_config()).stream();
}

}  // namespace gnomon::rtl_test
