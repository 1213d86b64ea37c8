// SPDX-License-Identifier: Apache-2.0
#include "tests/rtl/topology/program_stream.hpp"

#include <array>
#include <gnomon/golden/codec.hpp>
#include <span>

#include "tests/rtl/topology/programs.hpp"
#include "tests/support/box_size.hpp"
#include "tests/support/perspective_registers.hpp"

namespace gnomon::rtl_test::topology {
namespace {

using golden::HardwareConfig;
using golden::Header;
using golden::Op;

class ProgramStream {
 public:
  ProgramStream(const HardwareConfig& config, const StreamOptions& options)
      : config_(config), options_(options), random_(options.seed), entries_left_(options.most_entries) {}

  std::vector<Word> take() {
    for (const Command& command : random_program(random_, config_.topology_config(), options_.commands)) {
      if (command.sets_registers)
        append_light(command.registers);
      else
        append(command);
      if (options_.doubtful_percent > 0) append_doubtful_ones();
    }
    append_fence(1, 0);
    return std::move(words_);
  }

 private:
  void append_registers(std::span<const std::int64_t> values, std::uint32_t first) {
    words_.push_back(encode(Header{.op = static_cast<std::uint8_t>(Op::SetRegisters),
                                   .count = static_cast<std::uint16_t>(values.size()),
                                   .arg = first}));
    for (const std::int64_t value : values) words_.push_back(static_cast<Word>(value));
  }

  void append_light(const ProjectionRegisters& directional) {
    if (config_.en_perspective && !random_.chance(20)) {
      const stimulus::AllRegisters registers =
          random_.chance(15) ? stimulus::extreme_perspective_registers(config_, 15, random_)
                             : stimulus::perspective_registers(config_, random_);
      light_ = stimulus::projection_registers(registers, config_);
      return append_registers(registers, 0);
    }
    light_ = directional;
    append_registers(directional.matrix, 0);
    append_registers(std::array{directional.offset_factor}, 12);
    if (config_.en_perspective)
      append_registers(std::array{std::int64_t{0}}, static_cast<std::uint32_t>(golden::Register::Projection));
  }

  void append(const Command& command) {
    std::uint32_t arg = command.arg;
    if (config_.en_perspective) {
      const auto clearance =
          static_cast<std::uint32_t>(random_.chance(20) ? 0 : random_.bits() >> random_.between(40, 60));
      if (light_.perspective.perspective && command.op == TopologyOp::ResolveTopology) arg = clearance;
    }
    append({.op = static_cast<std::uint8_t>(command.op), .flags = command.flags, .arg = arg}, command.items);
  }

  /// Of quads those that there is room for.
  void append(Header header, std::vector<Word> items) {
    constexpr std::size_t kQuad = golden::topology::kWordsPerQuad;
    if (header.op == static_cast<std::uint8_t>(TopologyOp::PutQuads) && items.size() % kQuad == 0) {
      std::vector<Word> kept;
      for (auto quad = items.begin(); quad != items.end(); quad += kQuad)
        if (has_room(std::span<const Word, kQuad>(quad, kQuad))) kept.insert(kept.end(), quad, quad + kQuad);
      items = std::move(kept);
    }
    header.count = static_cast<std::uint16_t>(items.size());
    words_.push_back(encode(header));
    words_.insert(words_.end(), items.begin(), items.end());
  }

  bool has_room(std::span<const Word, golden::topology::kWordsPerQuad> quad) {
    const std::int64_t entries = stimulus::box_size(quad, light_, config_.topology_config());
    if (entries > entries_left_) return false;
    entries_left_ -= entries;
    return true;
  }

  void append_fence(std::uint8_t flags, std::uint32_t tag) {
    words_.push_back(encode(Header{.op = static_cast<std::uint8_t>(Op::Fence), .flags = flags, .arg = tag}));
  }

  void append_doubtful_ones() {
    while (random_.chance(options_.doubtful_percent)) append_doubtful();
    if (random_.chance(20))
      append_fence(static_cast<std::uint8_t>(random_.between(0, 1)),
                   static_cast<std::uint32_t>(words_.size()));
  }

  void append_doubtful() {
    std::vector<Word> items(static_cast<std::size_t>(random_.chance(50) ? 0 : random_.between(0, 9)));
    for (Word& item : items) item = random_.bits();
    const auto first = static_cast<std::uint32_t>(random_.between(0, 1100));
    append({.op = static_cast<std::uint8_t>(random_.between(0x0F, 0x17)),
            .flags = static_cast<std::uint8_t>(random_.chance(70) ? 0 : random_.between(0, 7)),
            .arg = first | static_cast<std::uint32_t>(random_.between(0, 40)) << 24},
           std::move(items));
  }

  HardwareConfig config_;
  StreamOptions options_;
  stimulus::Random random_;
  std::int64_t entries_left_;
  ProjectionRegisters light_{};
  std::vector<Word> words_;
};

}  // namespace

std::vector<Word> program_stream(const HardwareConfig& config, const StreamOptions& options) {
  return ProgramStream(config, options).take();
}

}  // namespace gnomon::rtl_test::topology
