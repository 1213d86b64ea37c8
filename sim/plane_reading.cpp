// SPDX-License-Identifier: Apache-2.0
// The plane by READ_PLANE commands.
#include "sim/plane_reading.hpp"

#include <algorithm>
#include <gnomon/golden/codec.hpp>
#include <gnomon/golden/command.hpp>

namespace gnomon::sim {
namespace {

constexpr std::uint32_t kMaxReadEntries = 256;

std::uint32_t entries_of(const golden::HardwareConfig& config) {
  const auto side = static_cast<std::uint32_t>(config.plane_side());
  return side * side;
}

}  // namespace

std::vector<golden::Word> plane_commands(const golden::HardwareConfig& config) {
  std::vector<golden::Word> words;
  const std::uint32_t entries = entries_of(config);
  for (std::uint32_t first = 0; first < entries; first += kMaxReadEntries) {
    const std::uint32_t arg =
        golden::encode(golden::PlaneRange{first, std::min(kMaxReadEntries, entries - first)});
    words.push_back(
        golden::encode(golden::Header{static_cast<std::uint8_t>(golden::Op::ReadPlane), 0, 0, arg}));
  }
  return words;
}

std::vector<std::uint32_t> plane_of(const golden::HardwareConfig& config,
                                    std::span<const golden::Word> results) {
  std::vector<std::uint32_t> plane(entries_of(config), golden::kEmpty);
  for (const golden::Word word : results) {
    const golden::PlaneEntryResult entry = golden::decode_plane_entry_result(word);
    if (entry.present) plane.at(entry.index) = entry.depth;
  }
  return plane;
}

}  // namespace gnomon::sim
