// SPDX-License-Identifier: Apache-2.0
// Arrays for NumPy.
#include "host/pipeline/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace gnomon::pipeline {
static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

// Magic, version 1.0, length of the text, and the text padded so that the data begin at a multiple of 64.
std::string npy_header(std::size_t rows, std::size_t columns) {
  std::string text =
      fmt::format("{{'descr': '<i4', 'fortran_order': False, 'shape': ({}, {}), }}", rows, columns);
  constexpr std::size_t kPrefix = 10;
  text.append(63 - (kPrefix + text.size()) % 64, ' ');
  text.push_back('\n');
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes.push_back(static_cast<char>(text.size() & 0xFF));
  bytes.push_back(static_cast<char>(text.size() >> 8));
  return bytes + text;
}

std::string voxels_npy(const voxel::VoxelSet& voxels,
                       std::span<const std::vector<golden::VoxelState>> states) {
  for (const auto& light : states)
    if (light.size() != voxels.voxels.size()) throw std::invalid_argument("voxels_npy: one state a voxel");
  const auto place = [&](std::uint32_t i) {
    const voxel::Voxel& v = voxels.voxels[i];
    return std::tuple(v.x, v.y, v.z);
  };
  std::vector<std::uint32_t> order(voxels.voxels.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, place);
  std::vector<std::int32_t> numbers;
  numbers.reserve(order.size() * (3 + states.size()));
  for (const std::uint32_t i : order) {
    const voxel::Voxel& v = voxels.voxels[i];
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
    for (const auto& light : states) numbers.push_back(static_cast<std::int32_t>(light[i]));
  }
  std::string bytes = npy_header(order.size(), 3 + states.size());
  const auto data = std::as_bytes(std::span(numbers));
  bytes.append(static_cast<const char*>(static_cast<const void*>(data.data())), data.size());
  return bytes;
}

}  // namespace gnomon::pipeline
