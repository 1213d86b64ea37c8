// SPDX-License-Identifier: Apache-2.0
// Flat casters as closed polygon loops.
#include "host/slb/loop_scene.hpp"

#include <fmt/format.h>

namespace gnomon::slb {

double signed_area(const Loop& loop) {
  double twice = 0;
  // About the first vertex, so that a small loop far from the origin keeps its digits.
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) twice += (loop[i] - loop[0]).cross(loop[i + 1] - loop[0]);
  return twice / 2;
}

std::string place_text(std::size_t object, std::optional<std::size_t> loop,
                       std::optional<std::size_t> vertex) {
  std::string words = fmt::format("object {}", object), path = fmt::format("objects[{}]", object);
  if (loop) {
    words += fmt::format(", loop {}", *loop);
    path += fmt::format(".loops[{}]", *loop);
  }
  if (vertex) {
    words += fmt::format(", vertex {}", *vertex);
    path += fmt::format("[{}]", *vertex);
  }
  return fmt::format("{} ({})", words, path);
}

}  // namespace gnomon::slb
