// SPDX-License-Identifier: Apache-2.0
// Embree behind a value type: triangles in, hits out.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "host/base/vec.hpp"

namespace gnomon::metrics {

struct RayHit {
  float distance;      ///< in units of the ray's direction
  std::uint32_t mesh;  ///< in the order of `add`
  std::uint32_t triangle;
  float b, c;  ///< barycentric weights of the triangle's second and third corner
};

/// A set of triangle meshes. Watertight across edges whose vertices are equal to the bit. Single precision:
/// `center` is taken off every ray in double first, so coordinates should be given relative to the middle of
/// the scene. Queries are thread-safe once `commit` has returned. Throws std::runtime_error where Embree
/// fails.
class RayScene {
 public:
  explicit RayScene(const Vec3& center);
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;
  ~RayScene();

  void add(std::span<const std::array<float, 3>> points,
           std::span<const std::array<std::uint32_t, 3>> triangles);
  void commit();
  std::optional<RayHit> first_hit(const Vec3& origin, const Vec3& direction) const;
  /// `reach` in units of the direction, at least 0; may be infinite.
  bool any_hit(const Vec3& origin, const Vec3& direction, double reach) const;

  /// What Embree holds for it: triangles and the hierarchy over them.
  std::uint64_t memory_bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnomon::metrics
