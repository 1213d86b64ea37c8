// SPDX-License-Identifier: Apache-2.0
// voxels.npy is what NumPy reads: header, alignment, rows in order.
#include "host/pipeline/npy.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <stdexcept>

namespace gnomon::pipeline {
namespace {

voxel::Voxel voxel_at(std::uint16_t x, std::uint16_t y, std::uint16_t z) {
  voxel::Voxel v{};
  v.x = x;
  v.y = y;
  v.z = z;
  return v;
}

TEST(Npy, IsAnArrayOfInt32) {
  voxel::VoxelSet voxels;
  voxels.voxels = {voxel_at(7, 1, 300), voxel_at(2, 9, 4)};
  const std::vector<std::vector<golden::VoxelState>> states{
      {golden::VoxelState::Shadow, golden::VoxelState::Lit}};
  const std::string bytes = voxels_npy(voxels, states);

  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t text = static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + text) % 64, 0u);
  EXPECT_THAT(bytes.substr(10, text),
              testing::StartsWith("{'descr': '<i4', 'fortran_order': False, 'shape': (2, 4), }"));
  EXPECT_EQ(bytes[9 + text], '\n');
  std::array<std::int32_t, 8> rows{};
  ASSERT_EQ(bytes.size(), 10 + text + sizeof(rows));
  std::memcpy(rows.data(), bytes.data() + 10 + text, sizeof(rows));
  EXPECT_THAT(rows, testing::ElementsAre(2, 9, 4, 1, 7, 1, 300, 2));
}

TEST(Npy, SeveralLightsAreColumns) {
  voxel::VoxelSet voxels;
  voxels.voxels = {voxel_at(7, 1, 300), voxel_at(2, 9, 4)};
  const std::vector<std::vector<golden::VoxelState>> states{
      {golden::VoxelState::Shadow, golden::VoxelState::Lit},
      {golden::VoxelState::Shadow, golden::VoxelState::Shadow}};
  const std::string bytes = voxels_npy(voxels, states);
  EXPECT_THAT(bytes, testing::HasSubstr("'shape': (2, 5)"));
  std::array<std::int32_t, 10> rows{};
  std::memcpy(rows.data(), bytes.data() + bytes.size() - sizeof(rows), sizeof(rows));
  EXPECT_THAT(rows, testing::ElementsAre(2, 9, 4, 1, 2, 7, 1, 300, 2, 2));
}

TEST(Npy, OneStateAVoxel) {
  const std::vector<std::vector<golden::VoxelState>> states{{golden::VoxelState::Lit}};
  EXPECT_THROW(voxels_npy({}, states), std::invalid_argument);
}

}  // namespace
}  // namespace gnomon::pipeline
