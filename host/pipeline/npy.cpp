// SPDX-License-Identifier: Apache-2.0
// Arrays for NumPy.
#include "host/pipeline/npy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <stdexcept>
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

std::string voxels_npy(const voxel::VoxelSet& voxels, std::span<const golden::VoxelState> states) {
  if (states.size() != voxels.voxels.size()) throw std::invalid_argument("voxels_npy: one state a voxel");
  std::vector<std::array<std::int32_t, 4>> rows;
  rows.reserve(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const voxel::Voxel& v = voxels.voxels[i];
    rows.push_back({v.x, v.y, v.z, static_cast<std::int32_t>(states[i])});
  }
  std::ranges::sort(rows);
  std::string bytes = npy_header(rows.size(), 4);
  const auto data = std::as_bytes(std::span(rows));
  bytes.append(static_cast<const char*>(static_cast<const void*>(data.data())), data.size());
  return bytes;
}

}  // namespace gnomon::pipeline
