// SPDX-License-Identifier: Apache-2.0
// A point of a surface whose shadow is asked for.
#pragma once

namespace gnomon {

struct Receiver {
  float x, y, z;  ///< grid coordinates
  float facing;   ///< cosine between normal and light: not above 0 where the surface faces away
};

}  // namespace gnomon
