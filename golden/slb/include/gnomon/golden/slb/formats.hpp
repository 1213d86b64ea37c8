// SPDX-License-Identifier: Apache-2.0
// Records of the silhouette-line buffer: line, fragment, entry (docs/slb.md, "Records").
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/slb/config.hpp>
#include <vector>

namespace gnomon::golden::slb {

/// A corner of an outline, in 2^-SUBPIXEL_BITS pixels from the plane's lower left corner, with its depth
/// code.
struct Vertex {
  std::int64_t x = 0, y = 0;
  std::uint32_t depth = 0;
  bool operator==(const Vertex&) const = default;
};

/// A directed straight line through one pixel; the caster lies on its left.
struct Line {
  bool major = false;  ///< 1: x = f(y); 0: y = f(x)
  bool xsign = false;  ///< 1: the slope is negative
  bool cross = false;  ///< the stored crossing lies on the border M = cross
  bool inner = false;  ///< 1: the caster is where the minor coordinate is larger
  std::uint16_t frac = 0;
  std::uint16_t slope = 0;
  bool operator==(const Line&) const = default;
};

/// Sides of a pixel, counter-clockwise from its lower left corner.
enum class Side : std::uint8_t { Bottom = 0, Right = 1, Top = 2, Left = 3 };
constexpr Side opposite(Side side) {
  return static_cast<Side>((static_cast<unsigned>(side) + 2) % 4);
}

/// What the lines of a fragment mean.
enum class FragmentOp : std::uint8_t {
  One = 0,  ///< one chain: A
  And = 1,  ///< one chain with a convex corner: A and B
  Or = 2,   ///< one chain with a reflex corner: A or B
  Two = 3,  ///< two chains without corners
};

struct Fragment {
  std::uint32_t depth = 0;
  std::uint8_t object = 0;
  FragmentOp op = FragmentOp::One;
  Line a, b;
  std::uint8_t threshold_m1 = 0;  ///< T - 1, in a group's first fragment
  bool cont = false;              ///< belongs to the same object as the fragment before
  bool operator==(const Fragment&) const = default;

  int chains() const { return op == FragmentOp::Two ? 2 : 1; }
};

inline constexpr int kMaxFragments = 4;
inline constexpr int kCornerMin = -32, kCornerMax = 31;      ///< r saturates: 6 bits
inline constexpr int kWindingMin = -127, kWindingMax = 127;  ///< dw and carry-in saturate: 8 bits

struct Entry {
  std::uint8_t generation = 0;  ///< 0 is never valid
  std::uint8_t count = 0;
  bool overflow = false;   ///< a line or an object did not fit
  bool open = false;       ///< the last group belongs to the object being drawn
  std::int8_t corner = 0;  ///< r of the object being drawn
  std::uint32_t full_depth = 0;
  std::array<Fragment, kMaxFragments> fragments{};
  bool operator==(const Entry&) const = default;

  /// Index of the last group's first fragment; count if there is none.
  int last_group() const;
  /// Number of chains in the fragments first..last-1.
  int chains(int first, int last) const;
};

/// Bits of a line, most significant first: major, xsign, cross, inner, frac, slope.
std::uint32_t pack(const Line& line, const SlbConfig& config);
Line unpack_line(std::uint32_t bits, const SlbConfig& config);

/// An entry as stored_entry_bits() / 64 words, lowest first (docs/slb.md, "Entry"); `generation` is packed as
/// 0.
std::vector<std::uint64_t> pack(const Entry& entry, const SlbConfig& config);
Entry unpack_entry(const std::vector<std::uint64_t>& words, const SlbConfig& config);

}  // namespace gnomon::golden::slb
