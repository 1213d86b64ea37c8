// SPDX-License-Identifier: Apache-2.0
// Loops that meet borders, corners, capacity and each other; queries where they matter; commands out of
// order.
#include "tests/golden/slb/stimulus.hpp"

#include <algorithm>

namespace gnomon::golden::slb::testing {
namespace {

constexpr auto code(SlbOp op) {
  return static_cast<std::uint8_t>(op);
}

class Generator {
 public:
  Generator(std::uint64_t seed, const SlbConfig& config, const StimulusOptions& options)
      : random_(seed), config_(config), options_(options) {}

  std::vector<Command> stream() {
    const std::int64_t objects = random_.integer(1, options_.objects);
    for (std::int64_t i = 0; i < objects; ++i) {
      object(static_cast<std::uint8_t>(random_.integer(0, 255)));
      if (random_.integer(0, 3) == 0) queries(options_.queries / 4);
    }
    queries(options_.queries);
    if (random_.integer(0, 5) == 0) add(SlbOp::Clear, 0, 0, {});
    if (random_.integer(0, 1) == 0) object(1);
    queries(options_.queries / 4);
    if (options_.read_back) read_back();
    return std::move(commands_);
  }

 private:
  void add(SlbOp op, std::uint8_t flags, std::uint32_t arg, std::vector<Word> items) {
    if (random_.unit() < options_.error_share) add_error();
    commands_.push_back({code(op), flags, arg, std::move(items)});
  }

  /// Reserved flags, items where none belong, entries beyond the plane, and ops at the wrong moment.
  void add_error() {
    const auto op = static_cast<std::uint8_t>(random_.integer(kFirstSlbOp, kLastSlbOp));
    const auto flags = static_cast<std::uint8_t>(2u << random_.integer(0, 6));
    // Harmless where they are allowed, out of sequence elsewhere.
    static constexpr SlbOp kMisplaced[] = {SlbOp::Clear, SlbOp::Cover, SlbOp::Query, SlbOp::ReadEntries};
    switch (random_.integer(0, 3)) {
      case 0:
        commands_.push_back({op, flags, 0, {}});
        break;
      case 1:
        commands_.push_back({code(SlbOp::Fill), 0, 0, {1, 2, 3}});
        break;
      case 2:
        commands_.push_back({code(SlbOp::ReadEntries), 0, 0xFFFFFFFF, {}});
        break;
      default:
        commands_.push_back({code(kMisplaced[random_.integer(0, 3)]), 0, 0, {}});
        break;
    }
  }

  void read_back() {
    const std::int64_t side = config_.side(), entries = side * side;
    const std::int64_t count = std::min<std::int64_t>(entries, random_.integer(1, 256));
    std::int64_t first = 0;
    if (!places_.empty()) {
      const Vertex& v = places_[static_cast<std::size_t>(
          random_.integer(0, static_cast<std::int64_t>(places_.size()) - 1))];
      first = (v.y >> config_.subpixel_bits) * side + (v.x >> config_.subpixel_bits) - count / 2;
    }
    first = std::clamp<std::int64_t>(first, 0, entries - count);
    add(SlbOp::ReadEntries, 0,
        encode(EntryRange{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)}), {});
  }

  std::uint32_t depth() {
    switch (random_.integer(0, 4)) {
      case 0:
        return 0;
      case 1:
        return config_.no_depth() - static_cast<std::uint32_t>(random_.integer(0, 2));
      case 2:
        return 77;
      default:
        return static_cast<std::uint32_t>(random_.integer(0, config_.no_depth()));
    }
  }

  /// Sub-pixel coordinates between low and high pixels on a random lattice: whole, half, quarter pixels or
  /// free.
  Loop corners(double low, double high) {
    const int drop =
        random_.integer(0, 1) == 0 ? 0 : config_.subpixel_bits - static_cast<int>(random_.integer(0, 2));
    const auto scale = static_cast<double>(config_.subpixels());
    const auto limit = std::int64_t{1} << (config_.vertex_width() - 1);
    const auto coordinate = [&] {
      const auto free = static_cast<std::int64_t>(random_.between(low, high) * scale);
      return std::clamp((free >> drop) << drop, -limit, limit - 1);
    };
    Loop loop;
    const std::int64_t count = random_.integer(1, 12);
    for (std::int64_t i = 0; i < count; ++i) loop.push_back({coordinate(), coordinate(), depth()});
    return loop;
  }

  Loop star_at(double x, double y, double radius) {
    const int count = static_cast<int>(random_.integer(3, 40));
    return quantise(star(random_, count, 0.4 * radius, radius, {x, y}), config_, depth());
  }

  Loop some_loop() {
    const double side = config_.side(), x = random_.between(0, side), y = random_.between(0, side);
    Loop loop;
    switch (random_.integer(0, 7)) {
      case 0:
        loop = corners(-side, 2 * side - 1);
        break;
      case 1:
        loop = corners(0, side);
        break;
      case 2:
        loop = corners(x, x + 2);
        break;
      case 3:
        loop = star_at(side / 2, side / 2, 0.45 * side);
        break;
      case 4:
        loop = star_at(x, y, random_.between(0.1, 3));
        break;
      case 5:
        loop = star_at(side / 2, side / 2, random_.between(0.3, 1.5));
        break;
      case 6:
        loop = quantise({{1, 1}, {side - 1, 1.5}, {side - 1, side - 1}, {1.25, side - 1}}, config_, depth());
        break;
      default: {
        // A thin strip; several of them overflow pixels.
        const double far = 0.8 * side, width = random_.between(0.02, 0.6);
        loop = quantise({{2, y}, {far, side - y}, {far, side - y + width}, {2, y + width}}, config_, depth());
      }
    }
    if (random_.integer(0, 7) == 0) std::reverse(loop.begin(), loop.end());
    if (random_.integer(0, 7) == 0) loop.push_back(loop.front());
    if (random_.integer(0, 7) == 0) loop.insert(loop.begin() + 1, loop.front());
    if (!loop.empty()) places_.push_back(loop.back());
    return loop;
  }

  void loop() {
    std::vector<Word> items;
    for (const Vertex& v : some_loop()) items.push_back(encode(v, config_));
    if (items.size() > 1 && random_.integer(0, 3) == 0) {
      const auto cut = items.begin() + random_.integer(0, static_cast<std::int64_t>(items.size()));
      add(SlbOp::Loop, kLoopMore, 0, {items.begin(), cut});
      items.erase(items.begin(), cut);
    }
    add(SlbOp::Loop, 0, 0, std::move(items));
  }

  void object(std::uint8_t id) {
    const bool flat = random_.integer(0, 1) == 0;
    add(SlbOp::BeginObject, flat ? kBeginFlat : 0, std::uint32_t{id} << 24 | depth(), {});
    const std::int64_t loops = random_.integer(0, 7) == 0 ? 0 : random_.integer(1, 6);
    for (std::int64_t i = 0; i < loops; ++i) loop();
    if (loops == 0 && random_.integer(0, 1) == 0) {
      add(SlbOp::EndObject, 0, 0, {});
      return;
    }
    add(SlbOp::Fill, 0, 0, {});
    if (!flat) cover();
    add(SlbOp::EndObject, 0, 0, {});
  }

  void cover() {
    std::vector<Word> items;
    for (std::int64_t i = random_.integer(0, 60); i > 0; --i)
      items.push_back(
          encode(CoverSample{random_.integer(-2, config_.side() + 1), random_.integer(-2, config_.side() + 1),
                             depth(), static_cast<std::uint32_t>(random_.integer(0, 8))},
                 config_));
    add(SlbOp::Cover, 0, static_cast<std::uint32_t>(random_.integer(0, 50)), std::move(items));
  }

  void queries(int count) {
    std::vector<Word> items;
    const std::int64_t span = std::int64_t{config_.side()} << config_.query_bits;
    const std::int64_t near = std::int64_t{2} << config_.query_bits;
    const auto limit = std::int64_t{1} << (config_.query_width() - 1);
    for (int i = 0; i < count; ++i) {
      QueryPoint point{random_.integer(-span / 16, span + span / 16),
                       random_.integer(-span / 16, span + span / 16), depth()};
      if (!places_.empty() && random_.integer(0, 2) != 0) {
        const Vertex& v = places_[static_cast<std::size_t>(
            random_.integer(0, static_cast<std::int64_t>(places_.size()) - 1))];
        const auto scaled = [&](std::int64_t c) {
          const std::int64_t there = config_.query_bits >= config_.subpixel_bits
                                         ? c << (config_.query_bits - config_.subpixel_bits)
                                         : c >> (config_.subpixel_bits - config_.query_bits);
          return std::clamp(there + random_.integer(-near, near), -limit, limit - 1);
        };
        point.x = scaled(v.x);
        point.y = scaled(v.y);
      }
      items.push_back(encode(point, config_));
    }
    add(SlbOp::Query, 0, static_cast<std::uint32_t>(random_.integer(0, 1) * random_.integer(0, 40)),
        std::move(items));
  }

  Random random_;
  SlbConfig config_;
  StimulusOptions options_;
  std::vector<Command> commands_;
  std::vector<Vertex> places_;
};

}  // namespace

std::vector<Command> random_commands(std::uint64_t seed, const SlbConfig& config,
                                     const StimulusOptions& options) {
  return Generator(seed, config, options).stream();
}

std::vector<Word> to_words(const std::vector<Command>& commands) {
  std::vector<Word> words;
  for (const Command& c : commands) {
    words.push_back(Word{c.op} << 56 | Word{c.flags} << 48 | Word{c.items.size() & 0xFFFF} << 32 | c.arg);
    words.insert(words.end(), c.items.begin(), c.items.end());
  }
  return words;
}

}  // namespace gnomon::golden::slb::testing
