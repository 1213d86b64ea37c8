// SPDX-License-Identifier: Apache-2.0
// Flat casters as closed polygon loops: what `gnomon slb` reads (docs/slb-cli.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/base/vec.hpp"

namespace gnomon::slb {

/// Vertices in plane pixels, x to the right and y up, interior on the left; closed from the last to the
/// first.
using Loop = std::vector<Vec2>;

/// An object parallel to the plane: it covers the points around which its loops wind at least once.
struct FlatCaster {
  double depth = 0;  ///< 0 (at the light) .. 1
  std::vector<Loop> loops;
};

using LoopScene = std::vector<FlatCaster>;

/// A receiver: position in plane pixels, depth as a caster's.
struct Receiver {
  double x = 0, y = 0, z = 0;
};

/// Square pixels, positive if the loop runs counter-clockwise.
double signed_area(const Loop& loop);

/// "object 0, loop 1, vertex 2 (objects[0].loops[1][2])": where somebody finds it in the file.
std::string place_text(std::size_t object, std::optional<std::size_t> loop = {},
                       std::optional<std::size_t> vertex = {});

}  // namespace gnomon::slb
