// SPDX-License-Identifier: Apache-2.0
// Is a point inside a line, a chain, a group? Without division (docs/slb.md, "Query").
#pragma once

#include <cstdint>
#include <gnomon/golden/slb/formats.hpp>

namespace gnomon::golden::slb {

/// A point inside a pixel in 2^-scale_bits pixels from its lower left corner.
struct PixelPoint {
  std::int64_t x = 0, y = 0;
  int scale_bits = 1;
};

/// The closed half-plane on the line's inner side.
bool inside(const Line& line, const PixelPoint& point, const SlbConfig& config);
/// How many of the fragment's chains contain the point.
int chains_containing(const Fragment& fragment, const PixelPoint& point, const SlbConfig& config);
/// A single chain as the store would keep it.
bool chain_contains(FragmentOp op, const Line& a, const Line& b, const PixelPoint& point,
                    const SlbConfig& config);

/// A receiver: position in 2^-QUERY_BITS pixels, read at + 1/2; depth code.
struct QueryPoint {
  std::int64_t x = 0, y = 0;
  std::uint32_t depth = 0;
};

struct QueryAnswer {
  bool shadow = false;
  bool by_full = false;  ///< the full depth alone decides for shadow
  bool has_fragment = false;
  bool overflow = false;
  bool off_plane = false;
  bool by_lines = false;    ///< a group of fragments covers the point and is nearer
  std::uint8_t object = 0;  ///< of the first such group; 0 if none
  bool operator==(const QueryAnswer&) const = default;
};

QueryAnswer answer(const Entry& entry, const PixelPoint& point, std::uint32_t depth, std::uint32_t bias,
                   const SlbConfig& config);

}  // namespace gnomon::golden::slb
