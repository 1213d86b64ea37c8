// SPDX-License-Identifier: Apache-2.0
// Objects, queries and reads as commands.
#include "tests/support/slb_stage.hpp"

#include <algorithm>
#include <utility>

namespace gnomon::stimulus {

using golden::Header;
using golden::Word;
using golden::slb::QueryPoint;

SlbStage::SlbStage(const golden::HardwareConfig& hardware)
    : config(hardware), slb(hardware.slb_config()), side(slb.side()), writer(hardware) {}

void SlbStage::object(std::uint8_t id, std::uint32_t depth, const std::vector<Polygon>& polygons) {
  writer.begin_object(id, depth);
  for (const Polygon& polygon : polygons) writer.loop(loop(polygon));
  writer.fill();
  writer.end_object();
}

void SlbStage::ask(double x, double y, double radius, std::uint32_t depth, std::uint32_t bias) {
  constexpr int kSteps = 12;
  std::vector<QueryPoint> points;
  const auto scale = static_cast<double>(std::int64_t{1} << slb.query_bits);
  const auto limit = std::int64_t{1} << (slb.query_width() - 1);
  for (int row = 0; row <= kSteps; ++row)
    for (int column = 0; column <= kSteps; ++column) {
      const auto place = [&](double centre, int step) {
        const auto there = static_cast<std::int64_t>((centre + radius * (2.0 * step / kSteps - 1)) * scale);
        return std::clamp(there, -limit, limit - 1);
      };
      const auto z = static_cast<std::int64_t>(depth) + bias + (row + column) % 3 - 1;
      const auto most = static_cast<std::int64_t>(slb.no_depth());
      points.push_back({place(x, column), place(y, row),
                        static_cast<std::uint32_t>(std::clamp<std::int64_t>(z, 0, most))});
    }
  writer.query(points, bias);
}

void SlbStage::read() {
  const std::uint32_t entries = std::uint32_t{1} << (2 * slb.plane_log2);
  const std::uint32_t few = std::min(entries, 64U);
  writer.read_entries((entries - few) / 2, few);
  writer.read_entries(entries - few, few);
}

void SlbStage::raw(const Header& header, std::span<const Word> items) {
  const auto before = writer.take();
  words_.insert(words_.end(), before.begin(), before.end());
  words_.push_back(encode(header));
  words_.insert(words_.end(), items.begin(), items.end());
}

std::vector<Word> SlbStage::finish() {
  writer.fence(0x51B, true);
  writer.fence(0x51C, false);
  const auto rest = writer.take();
  words_.insert(words_.end(), rest.begin(), rest.end());
  return std::move(words_);
}

}  // namespace gnomon::stimulus
