// SPDX-License-Identifier: Apache-2.0
// Borders are matched by five points of each piece, hashed in the direction that sorts first.
#include "host/metrics/face_borders.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <tuple>

namespace gnomon::metrics {
namespace {

struct HashedPiece {
  std::uint64_t hash;
  BorderPiece piece;
};

auto order(const HashedPiece& p) {
  return std::tuple(p.hash, p.piece.face, p.piece.side, p.piece.t0, p.piece.t1);
}

auto coordinates(const Vec3& p) {
  return std::tuple(p.x, p.y, p.z);
}

std::uint64_t mix(std::uint64_t hash, double value) {
  // Adding zero makes -0 and +0 the same; the rest is the finaliser of splitmix64.
  std::uint64_t x =
      hash ^ (std::bit_cast<std::uint64_t>(value + 0.0) + 0x9E3779B97F4A7C15ULL + (hash << 6) + (hash >> 2));
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

using Points = std::array<Vec3, 5>;

HashedPiece hashed(const BorderPiece& where, const Points& points) {
  const bool reversed = std::lexicographical_compare(
      points.rbegin(), points.rend(), points.begin(), points.end(),
      [](const Vec3& a, const Vec3& b) { return coordinates(a) < coordinates(b); });
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[reversed ? points.size() - 1 - i : i];
    hash = mix(mix(mix(hash, p.x), p.y), p.z);
  }
  HashedPiece result{hash, where};
  result.piece.reversed = reversed;
  return result;
}

void hash_side(const surface::LimitSurface& surface, std::uint32_t face, Side side, HashedPiece* out) {
  std::array<Vec3, 9> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [u, v] = on_side(side, static_cast<double>(i) / 8);
    points[i] = surface.position(face, u, v);
  }
  const auto pick = [&](std::size_t first, std::size_t step) {
    return Points{points[first], points[first + step], points[first + 2 * step], points[first + 3 * step],
                  points[first + 4 * step]};
  };
  out[0] = hashed({face, side, 0.0f, 1.0f, false}, pick(0, 2));
  out[1] = hashed({face, side, 0.0f, 0.5f, false}, pick(0, 1));
  out[2] = hashed({face, side, 0.5f, 1.0f, false}, pick(4, 1));
}

}  // namespace

FaceBorders::FaceBorders(const surface::LimitSurface& surface, std::span<const std::uint32_t> faces) {
  std::vector<HashedPiece> all(faces.size() * 12);
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    for (std::size_t side = 0; side < 4; ++side)
      hash_side(surface, faces[i], static_cast<Side>(side), &all[i * 12 + side * 3]);
  });
  tbb::parallel_sort(all.begin(), all.end(),
                     [](const HashedPiece& a, const HashedPiece& b) { return order(a) < order(b); });
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].hash == all[begin].hash) ++end;
    if (end - begin < 2) continue;
    for (std::size_t i = begin; i < end; ++i) pieces_.push_back(all[i].piece);
    starts_.push_back(pieces_.size());
  }
}

}  // namespace gnomon::metrics
