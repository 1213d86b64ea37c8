// SPDX-License-Identifier: Apache-2.0
// The SystemVerilog package and registers against the C++ codec: the same words, fields and widths.
#include <gtest/gtest.h>

#include <array>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/config.hpp>
#include <gnomon/golden/slb/codec.hpp>
#include <random>

#include "Vprobe_default.h"
#include "Vprobe_wide.h"
#include "sim/counter_names.hpp"

namespace gnomon::rtl_test {
namespace {

using namespace golden;

template <class Model>
void clock(Model& probe) {
  probe.clk_i = 0;
  probe.eval();
  probe.clk_i = 1;
  probe.eval();
}

template <class Model>
struct Build;
template <>
struct Build<Vprobe_default> {
  static HardwareConfig config() {
    HardwareConfig config;
    config.en_perspective = true;
    return config;
  }
};
template <>
struct Build<Vprobe_wide> {  // as in CMakeLists.txt
  static HardwareConfig config() {
    return {.voxel_bits = 11,
            .voxel_frac_bits = 5,
            .normal_bits = 5,
            .matrix_frac_bits = 28,
            .depth_bits = 24,
            .plane_log2 = 12,
            .en_perspective = true};
  }
};

template <class Model>
class Package : public testing::Test {
 protected:
  Model probe_;
  HardwareConfig config_ = Build<Model>::config();
  std::mt19937_64 random_{20051};

  std::uint64_t bits(int count) { return random_() >> (64 - count); }
};
using Probes = testing::Types<Vprobe_default, Vprobe_wide>;
TYPED_TEST_SUITE(Package, Probes);

TYPED_TEST(Package, ConstantsAreTheCodecs) {
  const std::array<std::uint64_t, 35> expected{
      std::uint64_t(Op::Nop),
      std::uint64_t(Op::SetRegisters),
      std::uint64_t(Op::ClearPlane),
      std::uint64_t(Op::Fence),
      std::uint64_t(Op::ReadPlane),
      std::uint64_t(Op::ProjectVoxels),
      std::uint64_t(Op::ResolveVoxels),
      kFenceClearSticky,
      kResolveTwoSided,
      kRegisterCount,
      std::uint64_t(ErrorCode::UnknownOp),
      std::uint64_t(ErrorCode::FeatureAbsent),
      std::uint64_t(ErrorCode::BadRegister),
      std::uint64_t(ErrorCode::BadArgument),
      std::uint64_t(ErrorCode::ReservedFlag),
      std::uint64_t(VoxelState::Lit),
      std::uint64_t(VoxelState::Shadow),
      std::uint64_t(slb::SlbOp::Clear),
      std::uint64_t(slb::SlbOp::BeginObject),
      std::uint64_t(slb::SlbOp::Loop),
      std::uint64_t(slb::SlbOp::Fill),
      std::uint64_t(slb::SlbOp::Cover),
      std::uint64_t(slb::SlbOp::EndObject),
      std::uint64_t(slb::SlbOp::Query),
      std::uint64_t(slb::SlbOp::ReadEntries),
      slb::kBeginFlat,
      slb::kLoopMore,
      std::uint64_t(ErrorCode::BadSequence),
      sim::kSlbEventNames.size(),
      sim::kFirstSlbCounter,
      sim::kFirstCycleCounter,
      sim::kPassNames.size() - 1,
      kAllRegisterCount,
      sim::kPerspectiveEventNames.size(),
      sim::kFirstPerspectiveCounter,
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    this->probe_.constant_i = static_cast<CData>(i);
    this->probe_.eval();
    EXPECT_EQ(this->probe_.constant_o, expected[i]) << "constant " << i;
  }
}

TYPED_TEST(Package, HeadersHaveTheCodecsFields) {
  for (int i = 0; i < 1000; ++i) {
    const Word word = this->bits(64);
    const Header header = decode_header(word);
    this->probe_.header_i = word;
    this->probe_.eval();
    ASSERT_EQ(this->probe_.header_op_o, header.op);
    ASSERT_EQ(this->probe_.header_flags_o, header.flags);
    ASSERT_EQ(this->probe_.header_count_o, header.count);
    ASSERT_EQ(this->probe_.header_arg_o, header.arg);
  }
}

TYPED_TEST(Package, ResultsAreEncodedAsTheCodecDoes) {
  auto& probe = this->probe_;
  for (int i = 0; i < 1000; ++i) {
    const FenceResult fence{static_cast<std::uint32_t>(this->bits(11)) & 0x727u,
                            static_cast<std::uint32_t>(this->bits(32))};
    const PlaneEntryResult entry{static_cast<std::uint32_t>(this->bits(24)), this->bits(1) != 0,
                                 static_cast<std::uint32_t>(this->bits(24))};
    const ErrorResult error{static_cast<std::uint8_t>(this->bits(8)),
                            static_cast<std::uint32_t>(this->bits(32))};
    const VoxelResult voxel{.state = this->bits(1) ? VoxelState::Lit : VoxelState::Shadow,
                            .facing_away = this->bits(1) != 0,
                            .off_plane = this->bits(1) != 0,
                            .uncertain = this->bits(1) != 0,
                            .offset_empty = this->bits(1) != 0,
                            .beyond_max = this->bits(1) != 0,
                            .nearest = static_cast<std::uint32_t>(this->bits(24)),
                            .delta = static_cast<std::uint32_t>(this->bits(24))};
    probe.sticky_i = static_cast<SData>(fence.sticky);
    probe.tag_i = fence.tag;
    probe.index_i = entry.index;
    probe.present_i = entry.present;
    probe.depth_i = entry.depth;
    probe.error_i = error.error;
    probe.command_index_i = error.command_index;
    probe.state_i = static_cast<CData>(voxel.state);
    probe.facing_away_i = voxel.facing_away;
    probe.off_plane_i = voxel.off_plane;
    probe.uncertain_i = voxel.uncertain;
    probe.offset_empty_i = voxel.offset_empty;
    probe.beyond_max_i = voxel.beyond_max;
    probe.nearest_i = voxel.nearest;
    probe.delta_i = voxel.delta;
    probe.eval();
    ASSERT_EQ(probe.fence_o, encode(fence));
    ASSERT_EQ(probe.plane_entry_o, encode(entry));
    ASSERT_EQ(probe.error_o, encode(error));
    ASSERT_EQ(probe.voxel_o, encode(voxel));
  }
}

TYPED_TEST(Package, AnswersAndEntriesOfTheSilhouetteLineBufferAreEncodedAsTheCodecDoes) {
  auto& probe = this->probe_;
  for (int i = 0; i < 1000; ++i) {
    const slb::QueryAnswer answer{.shadow = this->bits(1) != 0,
                                  .by_full = this->bits(1) != 0,
                                  .has_fragment = this->bits(1) != 0,
                                  .overflow = this->bits(1) != 0,
                                  .off_plane = this->bits(1) != 0,
                                  .by_lines = this->bits(1) != 0,
                                  .object = static_cast<std::uint8_t>(this->bits(8))};
    const auto number = static_cast<std::uint16_t>(this->bits(16));
    const slb::EntryHeader entry{static_cast<std::uint32_t>(this->bits(24)),
                                 static_cast<std::uint8_t>(this->bits(8))};
    probe.answer_i = static_cast<CData>(answer.shadow << 5 | answer.by_full << 4 | answer.by_lines << 3 |
                                        answer.has_fragment << 2 | answer.overflow << 1 | answer.off_plane);
    probe.object_i = answer.object;
    probe.number_i = number;
    probe.index_i = entry.index;
    probe.words_i = entry.words;
    probe.eval();
    ASSERT_EQ(probe.answer_o, encode(answer, number));
    ASSERT_EQ(probe.slb_entry_o, encode(entry));
  }
}

TYPED_TEST(Package, ItemsHaveTheCodecsFields) {
  auto& probe = this->probe_;
  for (int i = 0; i < 1000; ++i) {
    probe.item_i = this->bits(64);
    clock(probe);
    const VoxelItem item = decode_voxel(probe.item_i, this->config_);
    const VoxelItem taken{{probe.x_o, probe.y_o, probe.z_o},
                          {static_cast<std::int32_t>(probe.nx_o), static_cast<std::int32_t>(probe.ny_o),
                           static_cast<std::int32_t>(probe.nz_o)}};
    ASSERT_EQ(taken, item);
  }
}

/// What a register of this format keeps of a word.
Word kept(Word value, const RegisterFormat& format) {
  const int dropped = 64 - format.width;
  const Word top = value << dropped;
  return format.is_signed ? static_cast<Word>(static_cast<std::int64_t>(top) >> dropped) : top >> dropped;
}

TYPED_TEST(Package, RegistersHaveTheCodecsWidthsAndSigns) {
  auto& probe = this->probe_;
  probe.rst_ni = 0;
  clock(probe);
  probe.rst_ni = 1;
  for (int index = 0; index < kAllRegisterCount; ++index) {
    const RegisterFormat format = register_format(static_cast<Register>(index), this->config_);
    probe.register_index_i = static_cast<CData>(index);
    probe.register_write_i = 0;
    probe.eval();
    EXPECT_EQ(probe.register_o, 0u) << format.name << " after reset";
    probe.register_write_i = 1;
    for (const Word value :
         {Word{0}, ~Word{0}, Word{1} << (format.width - 1), this->bits(64), this->bits(64)}) {
      probe.register_value_i = value;
      clock(probe);
      EXPECT_EQ(probe.register_o, kept(value, format)) << format.name;
    }
  }
}

}  // namespace
}  // namespace gnomon::rtl_test
