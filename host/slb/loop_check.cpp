// SPDX-License-Identifier: Apache-2.0
// Legal loops that cast no shadow.
#include "host/slb/loop_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/slb/polygon_reference.hpp"

namespace gnomon::slb {
namespace {

constexpr std::size_t kShown = 3;

/// Collects the places of one kind of trouble.
class Kind {
 public:
  explicit Kind(std::string what) : what_(std::move(what)) {}
  void add(const std::string& place, const std::string& detail = "") {
    if (++count_ <= kShown) lines_.push_back(place + ": " + detail + what_);
  }
  void append_to(std::vector<std::string>& lines) const {
    lines.insert(lines.end(), lines_.begin(), lines_.end());
    if (count_ > kShown) lines.push_back(fmt::format("{} more: {}", count_ - kShown, what_));
  }

 private:
  std::string what_;
  std::size_t count_ = 0;
  std::vector<std::string> lines_;
};

/// The leftmost vertex, of those the lowest: a ray to its left meets no edge of its own loop.
Vec2 leftmost(const Loop& loop) {
  return *std::min_element(loop.begin(), loop.end(), [](const Vec2& a, const Vec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
}

}  // namespace

std::vector<std::string> loops_that_cast_nothing(const LoopScene& scene, int side) {
  const PolygonReference reference(scene, side);
  Kind clockwise(
      "clockwise and in no other loop of its object, casts nothing (interior is on the left, y up)");
  Kind flat("without area, casts nothing"), empty("no loops, casts nothing");
  for (std::size_t object = 0; object < scene.size(); ++object) {
    if (scene[object].loops.empty()) empty.add(place_text(object));
    for (std::size_t i = 0; i < scene[object].loops.size(); ++i) {
      const Loop& loop = scene[object].loops[i];
      const double area = signed_area(loop);
      if (area == 0)
        flat.add(place_text(object, i));
      else if (area < 0 && reference.winding(object, leftmost(loop)) <= 0)
        clockwise.add(place_text(object, i), fmt::format("signed area {:.6g} square pixels, ", area));
    }
  }
  std::vector<std::string> lines;
  if (scene.empty()) lines.emplace_back("no objects, everything is lit");
  for (const Kind* kind : {&clockwise, &flat, &empty}) kind->append_to(lines);
  return lines;
}

}  // namespace gnomon::slb
