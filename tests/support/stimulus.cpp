// SPDX-License-Identifier: Apache-2.0
// Random streams: a walk over the steps below.
#include "tests/support/stimulus.hpp"

#include <algorithm>
#include <array>
#include <gnomon/golden/command.hpp>
#include <gnomon/golden/stream.hpp>
#include <gnomon/golden/vpu.hpp>
#include <optional>
#include <span>
#include <utility>

#include "tests/support/perspective_registers.hpp"
#include "tests/support/random.hpp"
#include "tests/support/scene_registers.hpp"
#include "tests/support/slb_source.hpp"
#include "tests/support/voxel_patterns.hpp"

namespace gnomon::stimulus {
namespace {

using golden::HardwareConfig;
using golden::Header;
using golden::Op;
using golden::Register;
using golden::VoxelItem;
using golden::Word;

class Walk {
 public:
  Walk(const HardwareConfig& config, const Options& options)
      : config_(config), options_(options), random_(options.seed), writer_(config) {
    if (config.en_slb) slb_.emplace(config, options.seed, options.max_items, options.illegal_percent);
  }

  std::vector<Word> run() {
    set_all_registers();
    for (int i = 1; i < options_.commands; ++i) step();
    writer_.fence(static_cast<std::uint32_t>(random_.bits()), false);
    flush();
    return std::move(words_);
  }

 private:
  void step();
  AllRegisters any_registers();
  void set_all_registers();
  void set_some_registers();
  bool in_perspective() const;
  std::size_t count_registers() const { return static_cast<std::size_t>(golden::register_count(config_)); }
  void project();
  void resolve();
  void read_plane();
  void nop();
  void raw_voxels();
  void slb();
  void illegal();
  void random_header();

  std::size_t item_count() { return static_cast<std::size_t>(random_.between(0, options_.max_items)); }
  std::vector<VoxelItem> new_items();
  /// Moves what the writer has to the stream, so that words of our own can follow.
  void flush() {
    const auto words = writer_.take();
    words_.insert(words_.end(), words.begin(), words.end());
  }
  /// A header as it is, and as many items of random bits as it announces.
  void raw(const Header& header) {
    flush();
    words_.push_back(encode(header));
    for (int i = 0; i < header.count; ++i) words_.push_back(random_.bits());
  }
  std::uint16_t few() { return static_cast<std::uint16_t>(random_.between(0, 5)); }
  /// What is said about hardware with registers up to DELTA_MAX, as if its last were that of this hardware:
  /// beyond it lie those that no hardware has.
  std::uint32_t near_last_register(std::uint32_t first, std::uint32_t count) const {
    if (first > golden::kAllRegisterCount) return first;
    const bool beyond = first + count > golden::kRegisterCount;
    return beyond || config_.en_perspective ? first + golden::kPerspectiveRegisterCount : first;
  }
  std::uint32_t any_arg() { return static_cast<std::uint32_t>(random_.bits()); }

  HardwareConfig config_;
  Options options_;
  Random random_;
  golden::StreamWriter writer_;
  std::optional<SlbSource> slb_;
  std::vector<Word> words_;
  AllRegisters registers_{};
  std::vector<VoxelItem> projected_;  ///< lately; what a resolve is about
};

void Walk::step() {
  if (random_.chance(options_.illegal_percent)) return illegal();
  if (slb_ && random_.chance(50)) return slb();
  const std::int64_t kind = random_.between(0, 99);
  if (kind < 35) return project();
  if (kind < 70) return resolve();
  if (kind < 75) return set_all_registers();
  if (kind < 80) return set_some_registers();
  if (kind < 86) return read_plane();
  if (kind < 89) return writer_.clear_plane();
  if (kind < 94) return writer_.fence(any_arg(), random_.chance(40));
  if (kind < 97) return raw_voxels();
  nop();
}

/// The first 18 from the generators for one projection; with the other, all of them.
AllRegisters Walk::any_registers() {
  const bool extreme = random_.chance(options_.extreme_percent);
  if (config_.en_perspective && random_.chance(75)) {
    return extreme ? extreme_perspective_registers(config_, 15, random_)
                   : perspective_registers(config_, random_);
  }
  const RegisterValues values =
      extreme ? extreme_registers(config_, random_) : scene_registers(config_, random_);
  AllRegisters all{};
  std::copy(values.begin(), values.end(), all.begin());
  return all;
}

void Walk::set_all_registers() {
  registers_ = any_registers();
  writer_.set_registers(Register::MatrixUx, std::span(registers_).first(count_registers()));
}

void Walk::set_some_registers() {
  const AllRegisters other = any_registers();
  const auto first =
      static_cast<std::size_t>(random_.between(0, static_cast<std::int64_t>(count_registers()) - 1));
  const auto count = std::min(static_cast<std::size_t>(random_.between(0, 4)), count_registers() - first);
  std::copy_n(other.begin() + static_cast<std::ptrdiff_t>(first), count,
              registers_.begin() + static_cast<std::ptrdiff_t>(first));
  writer_.set_registers(static_cast<Register>(first), std::span(other).subspan(first, count));
}

bool Walk::in_perspective() const {
  const auto projection = static_cast<std::size_t>(Register::Projection);
  return (registers_[projection] & golden::kProjectionPerspective) != 0;
}

std::vector<VoxelItem> Walk::new_items() {
  const auto pattern = static_cast<Pattern>(random_.between(0, kPatternCount - 1));
  const std::size_t count = item_count();
  RegisterValues values{};
  std::copy_n(registers_.begin(), values.size(), values.begin());
  if (in_perspective()) values = pattern_registers(registers_, config_);
  return voxel_pattern(pattern, count, values, config_, random_);
}

void Walk::project() {
  projected_ = new_items();
  writer_.project(projected_);
}

void Walk::resolve() {
  const bool two_sided = random_.chance(30);
  if (!config_.en_vpu_offset) return raw({static_cast<std::uint8_t>(Op::ResolveVoxels), two_sided, few(), 0});
  if (random_.chance(20)) return writer_.resolve(new_items(), two_sided);
  if (random_.chance(40)) std::reverse(projected_.begin(), projected_.end());
  writer_.resolve(projected_, two_sided);
}

void Walk::read_plane() {
  const std::int64_t entries = std::int64_t{1} << (2 * config_.plane_log2);
  const std::int64_t count = random_.chance(80) ? random_.between(1, 20) : random_.between(200, 256);
  golden::Vpu vpu(config_);
  std::int64_t first = random_.between(0, entries - count);
  if (!projected_.empty() && random_.chance(80)) {  // where something was projected
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      vpu.set(static_cast<Register>(i), static_cast<Word>(registers_[i]));
    }
    const VoxelItem& voxel = random_.pick(std::span<const VoxelItem>(projected_));
    const auto point = in_perspective() ? vpu.land(vpu.see(voxel)) : vpu.land(vpu.accumulate(voxel));
    if (point.on_plane) first = std::min(static_cast<std::int64_t>(vpu.index(point)), entries - count);
  }
  writer_.read_plane(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count));
}

void Walk::nop() {
  const std::uint16_t count = few();
  raw({static_cast<std::uint8_t>(Op::Nop), 0, count, any_arg()});
}

/// Voxel items of random bits, those that an item does not use among them, and an argument to be ignored.
void Walk::raw_voxels() {
  const auto count = static_cast<std::uint16_t>(item_count());
  raw({static_cast<std::uint8_t>(Op::ProjectVoxels), 0, count, any_arg()});
  if (config_.en_vpu_offset) raw({static_cast<std::uint8_t>(Op::ResolveVoxels), 1, count, any_arg()});
}

/// A few of the buffer's commands; an object is cut anywhere.
void Walk::slb() {
  flush();
  for (std::int64_t left = random_.between(1, 6); left > 0; --left) {
    const std::vector<Word> words = slb_->next();
    words_.insert(words_.end(), words.begin(), words.end());
  }
}

void Walk::illegal() {
  const std::uint16_t count = few();
  const std::uint32_t arg = any_arg();
  const auto flags = static_cast<std::uint8_t>(random_.between(0, 255));
  switch (random_.between(0, 5)) {
    case 0:
      return raw({static_cast<std::uint8_t>(random_.between(5, 15)), flags, count, arg});
    case 1:
      return raw({static_cast<std::uint8_t>(Op::SetRegisters), 0, count, arg});
    case 2:
      return raw({static_cast<std::uint8_t>(Op::SetRegisters), 0, 4,
                  near_last_register(static_cast<std::uint32_t>(random_.between(13, 19)), 4)});
    case 3:
      return raw({static_cast<std::uint8_t>(Op::ReadPlane), 0, 0,
                  golden::encode(golden::PlaneRange{
                      .first = (std::uint32_t{1} << (2 * config_.plane_log2)) - 2, .count = count + 1u})});
    default:
      return random_header();
  }
}

/// Any op in or near the table, any flags, a short list, any argument: for the order of errors.
void Walk::random_header() {
  static constexpr std::array<std::uint8_t, 20> kOps{0x00, 0x01, 0x02, 0x03, 0x04, 0x10, 0x11,
                                                     0x05, 0x12, 0xFF, 0x20, 0x21, 0x22, 0x23,
                                                     0x24, 0x25, 0x26, 0x27, 0x28, 0x1F};
  const std::uint8_t op = random_.pick(std::span<const std::uint8_t>(kOps));
  const auto flags =
      static_cast<std::uint8_t>(random_.chance(50) ? random_.between(0, 255) : random_.between(0, 1));
  const std::uint16_t count = few();
  const std::uint32_t arg =
      random_.chance(50) ? any_arg() : static_cast<std::uint32_t>(random_.between(0, 20));
  if (op == static_cast<std::uint8_t>(Op::SetRegisters)) {
    if (arg + count <= golden::kRegisterCount)
      return nop();  // random register contents would make the rest of the stream fall off the plane
    return raw({op, flags, count, near_last_register(arg, count)});
  }
  raw({op, flags, count, arg});
}

}  // namespace

std::vector<Word> random_stream(const HardwareConfig& config, const Options& options) {
  return Walk(config, options).run();
}

}  // namespace gnomon::stimulus
