// SPDX-License-Identifier: Apache-2.0
// Parameters of the silhouette-line buffer and the widths that follow from them (docs/slb.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gnomon::golden::slb {

inline constexpr int kMaxFrags = 4;
inline constexpr int kGenerationBits = 8;
inline constexpr int kCornerBits = 6;  ///< of r, two's complement

/// How fraction and slope are narrowed (docs/slb.md, "Rounding").
enum class Rounding : std::uint8_t {
  Better,     ///< the slope is rounded against the fraction as it will be read back
  Published,  ///< each field on its own, the fraction mirrored for negative slopes
};

/// One build of the unit. Names and meanings are those of the SystemVerilog parameters.
struct SlbConfig {
  int frac_bits = 7;       ///< FRAC_BITS F, 3..8
  int slope_bits = 7;      ///< SLOPE_BITS S, 3..9
  int frags = 2;           ///< FRAGS_PER_PIXEL K, 1..4
  int depth_bits = 20;     ///< DEPTH_BITS D, 8..24; code 2^D - 1 means none
  int plane_log2 = 8;      ///< SLB_PLANE_LOG2, 3..12 in hardware, 16 here
  int subpixel_bits = 10;  ///< SUBPIXEL_BITS s, fraction bits of a vertex, F+3..16
  int query_bits = 10;     ///< QUERY_BITS Q, fraction bits of a query, F+3..16
  Rounding rounding = Rounding::Better;

  bool operator==(const SlbConfig&) const = default;

  /// Nothing if the combination is legal; else one line naming the parameter, its value and the rule.
  std::optional<std::string> check() const;

  std::int64_t d0() const { return (std::int64_t{1} << frac_bits) - 1; }   ///< D0 = 2^F - 1
  std::int64_t d1() const { return (std::int64_t{1} << slope_bits) - 1; }  ///< D1 = 2^S - 1
  /// U: what a whole pixel measures in the walker's crossing positions.
  std::int64_t unit() const { return d0() << subpixel_bits; }
  int side() const { return 1 << plane_log2; }  ///< pixels
  std::int64_t subpixels() const { return std::int64_t{1} << subpixel_bits; }
  int vertex_width() const { return plane_log2 + 2 + subpixel_bits; }  ///< bits of a vertex coordinate
  int query_width() const { return plane_log2 + 2 + query_bits; }      ///< bits of a query coordinate
  std::uint32_t no_depth() const { return (std::uint32_t{1} << depth_bits) - 1; }

  int line_bits() const { return 4 + frac_bits + slope_bits; }
  int threshold_bits() const;  ///< of T - 1
  int count_bits() const;      ///< of the number of fragments
  int fragment_bits() const;
  int entry_bits() const;         ///< as laid out, before rounding up to a power of two
  int stored_entry_bits() const;  ///< the next power of two, at least 64
  int entry_words() const { return stored_entry_bits() / 64; }
};

/// The published encodings: 4-bit fraction and slope, 7-bit fraction and slope.
SlbConfig slb4();
SlbConfig slb7();

}  // namespace gnomon::golden::slb
