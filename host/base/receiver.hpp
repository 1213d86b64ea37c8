// SPDX-License-Identifier: Apache-2.0
// A point of a surface whose shadow is asked for.
#pragma once

namespace gnomon {

struct Receiver {
  float x, y, z;  ///< grid coordinates
  float facing;   ///< cosine between normal and light: negative where the surface faces away

  /// A surface along the light's way does not: a cosine as small as this is rounding.
  bool faces_light() const { return facing > 1e-9f; }
};

}  // namespace gnomon
