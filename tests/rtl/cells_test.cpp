// SPDX-License-Identifier: Apache-2.0
// Stream cells: nothing lost, doubled or reordered, valid held, and one word a cycle where nothing holds them
// back.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>

#include "Vstream_chain.h"
#include "Vstream_fifo.h"
#include "Vstream_skid.h"

namespace gnomon::rtl_test {
namespace {

struct Traffic {
  std::uint32_t sent = 0, taken = 0;
};

/// Sends 0, 1, 2, ... for `cycles` cycles and expects them in order; the ports are open with the given
/// chances in 256.
template <class Model>
Traffic drive(Model& cell, std::uint32_t seed, unsigned input_open, unsigned output_open, int cycles) {
  std::mt19937 random(seed);
  const auto clock = [&] {
    cell.clk_i = 0;
    cell.eval();
    cell.clk_i = 1;
    cell.eval();
  };
  cell.rst_ni = 0;
  cell.valid_i = 0;
  cell.ready_i = 0;
  clock();
  cell.rst_ni = 1;
  Traffic traffic;
  bool offering = false, held = false;
  for (int i = 0; i < cycles; ++i) {
    offering = offering || (random() & 255u) < input_open;
    cell.valid_i = offering;
    cell.data_i = traffic.sent;
    cell.ready_i = (random() & 255u) < output_open;
    cell.clk_i = 0;
    cell.eval();
    EXPECT_TRUE(!held || cell.valid_o) << "a word was withdrawn";
    if (cell.valid_o && cell.ready_i) {
      EXPECT_EQ(cell.data_o, traffic.taken);
      ++traffic.taken;
    }
    held = cell.valid_o && !cell.ready_i;
    if (offering && cell.ready_o) {
      ++traffic.sent;
      offering = false;
    }
    clock();
  }
  return traffic;
}

template <class Model>
class StreamCell : public testing::Test {};
using Cells = testing::Types<Vstream_skid, Vstream_fifo, Vstream_chain>;
TYPED_TEST_SUITE(StreamCell, Cells);

TYPED_TEST(StreamCell, KeepsEveryWordInOrder) {
  for (const unsigned input : {30u, 128u, 256u}) {
    for (const unsigned output : {30u, 128u, 256u}) {
      TypeParam cell;
      const Traffic traffic = drive(cell, input * 1000 + output, input, output, 4000);
      EXPECT_GT(traffic.taken, 300u);
      EXPECT_LE(traffic.sent - traffic.taken, 8u);  // the chain holds two skid buffers and the queue
    }
  }
}

TEST(StreamSkid, PassesOneWordACycle) {
  Vstream_skid cell;
  EXPECT_EQ(drive(cell, 1, 256, 256, 1000).taken, 999u);
}

TEST(StreamFifo, PassesOneWordACycle) {
  Vstream_fifo cell;
  EXPECT_EQ(drive(cell, 1, 256, 256, 1000).taken, 999u);
}

}  // namespace
}  // namespace gnomon::rtl_test
