// SPDX-License-Identifier: Apache-2.0
// The frame buffer with every port held back at random: each state is kept once and told once, the last one
// counts, and lookups pack what is there. The reference is a table of states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <gnomon/golden/codec.hpp>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include "Vframe_fast.h"
#include "Vframe_slow.h"

namespace gnomon::rtl_test {
namespace {

constexpr int kSide = 16, kLayers = 2;
constexpr std::uint8_t kResolve = 0x11, kClear = 0x30, kLookUp = 0x31;
constexpr std::uint8_t kKeep = 0x40, kQuiet = 0x80, kBrick = 1;

/// A voxel of a pass and what the pass says of it.
struct Voxel {
  int x = 0, y = 0, z = 0;
  std::uint8_t state = 1;

  /// VOXEL_FRAC_BITS = 2; the fraction must not matter.
  std::uint64_t item(std::uint64_t fraction) const {
    const auto position = [&](int cell) { return static_cast<std::uint64_t>(cell) << 2 | fraction; };
    return position(x) | position(y) << 6 | position(z) << 12;
  }
};

template <class Model>
class FrameBench {
 public:
  /// `open`: chance in 256 that a port is open in a cycle.
  FrameBench(std::uint32_t seed, int open) : random_(seed), open_(open) {
    model_->rst_ni = 0;
    clock();
    model_->rst_ni = 1;
    until_idle();
  }

  /// A resolve pass; gives the states that were told.
  std::vector<std::uint8_t> pass(const std::vector<Voxel>& voxels, std::uint8_t flags, unsigned layer) {
    start(kResolve, flags, layer);
    std::vector<std::uint8_t> told;
    std::size_t taken = 0, given = 0;
    const std::uint64_t first = cycles;
    bool offered = false;  // a word stays until it is taken
    while (given < voxels.size()) {
      if (cycles - first > 1000 + 100 * voxels.size()) throw std::runtime_error("the pass hangs");
      model_->voxel_valid_i = 0;
      model_->told_ready_i = flip();
      offered = given < taken && (offered || flip());
      model_->state_valid_i = offered;
      model_->state_i = voxels[std::min(given, voxels.size() - 1)].state;
      if (taken < voxels.size()) {
        model_->word_i = voxels[taken].item(random_() % 4);
        model_->eval();
        model_->voxel_valid_i = model_->voxel_ready_o && flip();
      }
      model_->eval();
      taken += model_->voxel_valid_i;
      if (model_->told_valid_o && model_->told_ready_i) told.push_back(model_->state_i);
      if (model_->state_valid_i && model_->state_ready_o) {
        ++given;
        offered = false;
      }
      clock();
    }
    pass_cycles = cycles - first;
    model_->voxel_valid_i = model_->state_valid_i = 0;
    until_idle();
    return told;
  }

  std::vector<std::uint64_t> look_up(const std::vector<Voxel>& voxels, std::uint8_t flags, unsigned layer) {
    start(kLookUp, flags, layer);
    std::vector<std::uint64_t> words;
    for (std::size_t i = 0; i < voxels.size(); clock()) {
      model_->word_i = voxels[i].item(random_() % 4);
      model_->item_valid_i = 1;
      model_->item_last_i = i + 1 == voxels.size();
      collect(words);
      i += model_->item_ready_o;
    }
    model_->item_valid_i = 0;
    while (!model_->idle_o) {
      collect(words);
      clock();
    }
    return words;
  }

  void clear() {
    start(kClear, 0, 0);
    until_idle();
  }

  std::uint64_t kept = 0, overwritten = 0, lookups = 0, empty = 0, bricks = 0, cycles = 0, pass_cycles = 0;

 private:
  bool flip() { return static_cast<int>(random_() % 256) < open_; }
  void start(std::uint8_t op, std::uint8_t flags, unsigned layer) {
    model_->word_i = golden::encode(golden::Header{op, flags, 1, layer << 28 | 0x0FFFFFFF});
    model_->start_i = 1;
    clock();
    model_->start_i = 0;
  }
  void collect(std::vector<std::uint64_t>& words) {
    model_->result_ready_i = flip();
    model_->eval();
    if (model_->result_valid_o && model_->result_ready_i) words.push_back(model_->result_o);
  }
  void until_idle() {
    for (model_->eval(); !model_->idle_o; clock()) {
    }
  }
  void clock() {
    model_->eval();
    if (model_->rst_ni) {
      const unsigned events = model_->events_o;
      kept += events >> 4 & 1;
      overwritten += events >> 3 & 1;
      lookups += events >> 2 & 1;
      empty += events >> 1 & 1;
      bricks += events & 1;
    }
    model_->clk_i = 1;
    model_->eval();
    model_->clk_i = 0;
    model_->eval();
    ++cycles;
  }

  std::unique_ptr<Model> model_ = std::make_unique<Model>();
  std::mt19937 random_;
  int open_;
};

/// The states, and the words in which they come.
struct Table {
  static constexpr std::size_t kVoxels = std::size_t{kSide} * kSide * kSide;
  std::vector<std::uint8_t> states = std::vector<std::uint8_t>(kLayers * kVoxels);

  std::uint8_t& at(unsigned layer, int x, int y, int z) {
    return states[layer * kVoxels + static_cast<std::size_t>((z * kSide + y) * kSide + x)];
  }
  std::vector<std::uint64_t> words(const std::vector<Voxel>& voxels, bool bricks, unsigned layer) {
    std::vector<std::uint64_t> words;
    const auto pack = [&](const std::vector<std::uint8_t>& some) {
      for (std::size_t i = 0; i < some.size(); i += 24) {
        const std::size_t count = std::min<std::size_t>(24, some.size() - i);
        std::uint64_t word = std::uint64_t{0x31} << 56 | std::uint64_t{count} << 48;
        for (std::size_t k = 0; k < count; ++k) word |= std::uint64_t{some[i + k]} << (2 * k);
        words.push_back(word);
      }
    };
    std::vector<std::uint8_t> one_each;
    for (const Voxel& v : voxels) {
      one_each.push_back(at(layer, v.x, v.y, v.z));
      if (!bricks) continue;
      std::vector<std::uint8_t> brick;
      brick.reserve(64);
      for (int i = 0; i < 64; ++i)
        brick.push_back(at(layer, v.x / 4 * 4 + i % 4, v.y / 4 * 4 + i / 4 % 4, v.z / 4 * 4 + i / 16));
      pack(brick);
    }
    if (!bricks) pack(one_each);
    return words;
  }
};

/// Crowded into a corner, so that bricks and voxels are hit again at every distance.
std::vector<Voxel> some_voxels(std::mt19937& random, std::size_t count) {
  const unsigned reach = random() % 2 == 0 ? 5 : kSide;
  std::vector<Voxel> voxels(count);
  for (Voxel& voxel : voxels) {
    voxel.x = static_cast<int>(random() % reach);
    voxel.y = static_cast<int>(random() % reach);
    voxel.z = static_cast<int>(random() % reach);
    voxel.state = static_cast<std::uint8_t>(1 + random() % 2);
  }
  return voxels;
}

template <class Model>
class Frame : public testing::Test {};
using Models = testing::Types<Vframe_fast, Vframe_slow>;
TYPED_TEST_SUITE(Frame, Models);

TYPED_TEST(Frame, KeepsTellsAndLooksUp) {
  for (const int open : {256, 128, 40}) {
    FrameBench<TypeParam> bench(7, open);
    Table table;
    std::mt19937 random(static_cast<std::uint32_t>(open));
    std::uint64_t kept = 0, overwritten = 0, compared = 0;
    for (int round = 0; round < 120; ++round) {
      const std::vector<Voxel> voxels = some_voxels(random, 1 + random() % 60);
      const unsigned layer = random() % kLayers;
      const auto flags =
          static_cast<std::uint8_t>((random() % 4 != 0 ? kKeep : 0) | (random() % 2 ? kQuiet : 0));
      std::vector<std::uint8_t> told;
      for (const Voxel& v : voxels) {
        if (!(flags & kQuiet)) told.push_back(v.state);
        if (!(flags & kKeep)) continue;
        std::uint8_t& state = table.at(layer, v.x, v.y, v.z);
        ++kept;
        overwritten += state != 0;
        state = v.state;
      }
      ASSERT_EQ(bench.pass(voxels, flags, layer), told) << "round " << round;
      if (round % 40 == 39) {
        bench.clear();
        table = {};
      }
      for (const std::uint8_t bricks : {std::uint8_t{0}, kBrick}) {
        const std::vector<Voxel> asked = some_voxels(random, 1 + random() % 60);
        const auto expected = table.words(asked, bricks != 0, layer);
        ASSERT_EQ(bench.look_up(asked, bricks, layer), expected) << "round " << round;
        compared += expected.size();
      }
    }
    EXPECT_GT(compared, 5'000u);
    EXPECT_GT(overwritten, 500u);
    EXPECT_EQ(bench.kept, kept);
    EXPECT_EQ(bench.overwritten, overwritten);
    EXPECT_GT(bench.lookups, bench.empty);
    EXPECT_GT(bench.empty, 100u);
    EXPECT_GT(bench.bricks, 1'000u);
  }
}

/// More clears than generations: what was kept 255 clears ago must not come back.
TYPED_TEST(Frame, ForgetsForGood) {
  FrameBench<TypeParam> bench(3, 256);
  const std::vector<Voxel> one{{1, 2, 3, 2}};
  Table table;
  bench.pass(one, kKeep | kQuiet, 0);
  for (int i = 0; i < 600; ++i) {
    bench.clear();
    ASSERT_EQ(bench.look_up(one, kBrick, 0), table.words(one, true, 0)) << "after clear " << i + 1;
  }
}

/// Every voxel in the same brick: forwarded, without a stall.
TEST(FrameThroughput, AStateACycle) {
  std::vector<Voxel> voxels(500);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i].x = static_cast<int>(i % 4);
  FrameBench<Vframe_fast> bench(1, 256);
  bench.pass(voxels, kKeep | kQuiet, 1);
  EXPECT_LE(bench.pass_cycles, voxels.size() + 4);
}

}  // namespace
}  // namespace gnomon::rtl_test
