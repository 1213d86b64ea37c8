// SPDX-License-Identifier: Apache-2.0
// Lines of entries, in either projection.
#include "told_items.hpp"

#include <gnomon/golden/frame/codec.hpp>
#include <gnomon/golden/slb/codec.hpp>

#include "cycles/plane_read.hpp"

namespace gnomon::golden {
namespace {

struct Lines {
  std::uint32_t own = 0, moved = 0;
};

Lines lines_orthographic(const Vpu& vpu, const VoxelItem& item, bool two_sided, int plane_log2) {
  const Accumulators acc = vpu.accumulate(item);
  Gradient gradient = vpu.gradient(item);
  if (two_sided && gradient.d > 0) gradient = {.u = -gradient.u, .v = -gradient.v, .d = -gradient.d};
  return {line_of(vpu.land(acc), plane_log2), line_of(vpu.land_offset(acc, gradient), plane_log2)};
}

/// Where a voxel behind the light reads is taken to be the first line.
Lines lines_perspective(const Vpu& vpu, const VoxelItem& item, bool two_sided, int plane_log2) {
  const perspective::Sight sight = vpu.see(item);
  if (sight.behind) return {};
  perspective::Slope slope = vpu.slope(item);
  if (two_sided && slope.d > 0) slope = -slope;
  return {line_of(vpu.land(sight), plane_log2), line_of(vpu.land_offset(sight, slope), plane_log2)};
}

}  // namespace

std::uint32_t line_of(const PlanePoint& point, int plane_log2) {
  const std::int64_t most = (std::int64_t{1} << (plane_log2 + 1)) - 1;
  const auto kept = [&](std::int64_t entry) {
    return static_cast<std::uint32_t>(saturate(entry, -most - 1, most) &
                                      ((std::int64_t{1} << plane_log2) - 1));
  };
  return cycles::line_of_entry(kept(point.u), kept(point.v));
}

std::vector<cycles::Item> resolved_items(const Vpu& vpu, const HardwareConfig& config,
                                         std::span<const Word> words, std::uint8_t flags) {
  const bool two_sided = (flags & kResolveTwoSided) != 0;
  std::vector<cycles::Item> items;
  items.reserve(words.size());
  for (const Word word : words) {
    const VoxelItem item = decode_voxel(word, config);
    const Lines lines = vpu.in_perspective() ? lines_perspective(vpu, item, two_sided, config.plane_log2)
                                             : lines_orthographic(vpu, item, two_sided, config.plane_log2);
    items.push_back({.line = lines.own,
                     .moved_line = lines.moved,
                     .kept = config.en_frame_buffer && (flags & frame::kKeep) != 0,
                     .quiet = config.en_frame_buffer && (flags & frame::kQuiet) != 0});
  }
  return items;
}

/// Of a point off the plane that with the low bits of its column and row.
std::vector<cycles::Item> queried_items(const slb::SlbConfig& config, std::span<const Word> words) {
  const std::int64_t mask = config.side() - 1;
  std::vector<cycles::Item> items;
  items.reserve(words.size());
  for (const Word word : words) {
    const slb::QueryPoint point = slb::decode_query(word, config);
    const std::int64_t column = point.x >> config.query_bits & mask,
                       row = point.y >> config.query_bits & mask;
    items.push_back({.line = static_cast<std::uint32_t>(row << config.plane_log2 | column)});
  }
  return items;
}

cycles::ItemWork take_covers(slb::SlbUnit& unit, const slb::FillSweep& swept, std::span<const Word> items) {
  const slb::SlbModel& model = unit.model();
  cycles::ItemWork work{.items = items.size()};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const slb::CoverSample sample = slb::decode_cover(items[i], model.config());
    const bool column_on = sample.column >= 0 && sample.column < model.config().side();
    const bool updates = column_on && sample.row >= swept.first_row && sample.row <= swept.last_row;
    if (updates) work.last_updating = i;
    const std::uint64_t used = model.counters().covers_used;
    unit.take(items.subspan(i, 1));
    const bool writes = model.counters().covers_used != used;
    if (writes) work.last_writing = i;
    work.each.push_back(
        {.line = updates ? static_cast<std::uint32_t>(sample.row << model.config().plane_log2 | sample.column)
                         : 0,
         .updates = updates,
         .writes = writes});
  }
  return work;
}

}  // namespace gnomon::golden
