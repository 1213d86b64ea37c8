// SPDX-License-Identifier: Apache-2.0
// Rounds vertices to sub-pixels and draws.
#include "bench/outline/buffer.hpp"

#include <cmath>

namespace gnomon::bench {
namespace {

golden::slb::SlbConfig config(int plane_log2, int frac_bits) {
  golden::slb::SlbConfig c;
  c.frac_bits = c.slope_bits = frac_bits;
  c.plane_log2 = plane_log2;
  c.subpixel_bits = frac_bits + 3;
  c.query_bits = 16;
  c.depth_bits = 8;
  return c;
}

}  // namespace

Buffer::Buffer(int plane_log2, int frac_bits, const std::vector<outline::Loop>& loops)
    : model_(config(plane_log2, frac_bits)) {
  const auto unit = static_cast<double>(model_.config().subpixels());
  model_.begin_object(0, true, 0);
  for (const outline::Loop& loop : loops) {
    std::vector<golden::slb::Vertex> vertices;
    for (const outline::Vertex& v : loop)
      vertices.push_back({std::llround(v.x * unit), std::llround(v.y * unit), 0});
    model_.loop(vertices);
  }
  model_.fill();
  model_.end_object();
}

}  // namespace gnomon::bench
