// SPDX-License-Identifier: Apache-2.0
// What the silhouette-line buffer holds, as a picture: pixels as a grid, restored lines over them
// (docs/slb-cli.md, "Pictures of the buffer").
#pragma once

#include <array>
#include <cstdint>
#include <gnomon/golden/slb/formats.hpp>
#include <span>

#include "host/render/picture.hpp"
#include "host/slb/polygon_reference.hpp"

namespace gnomon::slb {

/// A part of the plane, pixels.
struct Window {
  int column = 0, row = 0, columns = 0, rows = 0;
  bool operator==(const Window&) const = default;
};
Window whole_plane(const golden::slb::SlbConfig& config);

/// The square of at most `size` pixels a side with most to see: lines, and above all corners, several chains
/// in a pixel, and overflow. Of equal ones the lowest, then the leftmost.
Window busiest_window(std::span<const golden::slb::Entry> entries, const golden::slb::SlbConfig& config,
                      int size);

/// Colours, sRGB 0..255, so that legends can name them.
using Colour = std::array<std::uint8_t, 3>;
inline constexpr Colour kLitColour{252, 251, 247};       ///< nothing covers it
inline constexpr Colour kFullColour{150, 172, 206};      ///< pixel with a full depth
inline constexpr Colour kInsideColour{205, 217, 236};    ///< covered by restored lines
inline constexpr Colour kOverflowColour{247, 208, 205};  ///< lit part of a pixel where something did not fit
inline constexpr Colour kGridColour{196, 199, 204};
inline constexpr Colour kFaintColour{160, 163, 170};  ///< a stored line where it bounds nothing
inline constexpr Colour kExactColour{214, 94, 0};     ///< the outline that was drawn
/// Stored lines where they bound their object, by object modulo 4.
inline constexpr std::array<Colour, 4> kLineColours{
    {{18, 40, 92}, {130, 20, 60}, {10, 92, 62}, {96, 52, 132}}};

struct BufferPictureOptions {
  int scale = 48;       ///< image pixels a side of a plane pixel; without a grid below 6
  int supersample = 3;  ///< samples an image pixel on each axis
};

/// `entries`: the whole plane, row-major, as READ_ENTRIES gives them. `outlines` (plane pixels) are drawn
/// thinly on top, for comparison; may be empty. Row 0 at the bottom, as the plane's y points up.
render::Image buffer_picture(std::span<const golden::slb::Entry> entries,
                             const golden::slb::SlbConfig& config, const Window& window,
                             const BufferPictureOptions& options, std::span<const OutlineEdge> outlines = {});

}  // namespace gnomon::slb
