// SPDX-License-Identifier: Apache-2.0
// The legality rules of docs/frame-buffer.md.
#include <gnomon/golden/frame/config.hpp>

namespace gnomon::golden::frame {

std::optional<std::string> FrameConfig::check() const {
  constexpr int kMostLayersLog2 = 3;
  constexpr int kMostBitsLog2 = 34;  // 2 GiB
  if (layers_log2 < 0 || layers_log2 > kMostLayersLog2)
    return "FRAME_LAYERS_LOG2=" + std::to_string(layers_log2) + " is out of range 0.." +
           std::to_string(kMostLayersLog2);
  if (3 * voxel_bits + layers_log2 + 1 > kMostBitsLog2)
    return "3 * VOXEL_BITS + FRAME_LAYERS_LOG2 + 1 = " + std::to_string(3 * voxel_bits + layers_log2 + 1) +
           " exceeds " + std::to_string(kMostBitsLog2) + ": a frame buffer has 2 GiB at most";
  return std::nullopt;
}

}  // namespace gnomon::golden::frame
