// SPDX-License-Identifier: Apache-2.0
// Exact shadows: rays against the limit surface, tessellated until it no longer matters
// (docs/error-metrics.md).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/base/light.hpp"
#include "host/base/vec.hpp"
#include "host/metrics/tessellation.hpp"
#include "host/surface/limit_surface.hpp"

namespace gnomon::metrics {

using gnomon::DirectionalLight;

/// The exact answer at a surface point.
enum class Exact : std::uint8_t {
  Lit,
  Cast,      ///< faces the light, but something is in between
  Attached,  ///< faces away from the light, or is edge-on to it (cosine below 1e-9)
  Outside,   ///< faces a spot, but lies outside its cone
};
constexpr bool in_shadow(Exact answer) {
  return answer != Exact::Lit;
}

/// A point on the limit surface of `object`, with its unit normal.
struct SurfaceQuery {
  Vec3 point, normal;
  std::uint32_t object = 0;
};

/// What the objects are like, by their number. Missing entries are closed, cast and receive.
struct ReferenceObjects {
  std::vector<bool> two_sided;  ///< open surfaces: the normal is turned to the light before anything else
  std::vector<bool> casts;      ///< false: no ray meets it
  std::vector<bool> receives;   ///< false: lit wherever it faces a light that reaches it
};

/// What a ray meets.
struct SheetsMet {
  double nearest = 0;       ///< of the first, in units of the ray's direction; 0 if there is none
  std::uint32_t count = 0;  ///< sheets that face the ray's start; of open surfaces both sides do
};

/// Answers shadow queries for one light, in grid coordinates. Thread-safe.
class ExactReference {
 public:
  /// Throws std::invalid_argument for a light without a finite place or direction.
  ExactReference(std::span<const surface::LimitSurface> surfaces, ReferenceObjects objects,
                 const Light& light, const TessellationOptions& options = {});
  /// Objects that all cast and receive.
  ExactReference(std::span<const surface::LimitSurface> surfaces, std::vector<bool> two_sided,
                 const Light& light, const TessellationOptions& options = {});
  /// The same surfaces under another light, without tessellating them again.
  ExactReference relit(const Light& light) const;
  ExactReference(ExactReference&&) noexcept;
  ExactReference& operator=(ExactReference&&) noexcept;
  ~ExactReference();

  Exact classify(const SurfaceQuery& query) const;
  /// Cosine between the normal at a point and the way to the light; never negative for a two-sided object.
  double facing(const Vec3& point, const Vec3& normal, std::uint32_t object) const;
  bool occluded(const Vec3& point, const Vec3& normal, std::uint32_t object) const;
  /// Whether anything lies between a point of space and the light.
  bool blocked(const Vec3& point) const;
  /// All sheets of the objects with `of[object]` (missing: none) that a ray from `start`, outside every
  /// closed object, along `direction`, of unit length, meets.
  SheetsMet sheets(const Vec3& start, const Vec3& direction, const std::vector<bool>& of) const;
  /// All queries, on all cores.
  std::vector<Exact> classify(std::span<const SurfaceQuery> queries) const;

  const Light& light() const;
  Vec3 to_light(const Vec3& point) const;  ///< unit vector; zero at the light itself
  bool receives(std::uint32_t object) const;
  double sag() const;   ///< voxels
  double lift() const;  ///< voxels by which a ray starts above the surface
  std::size_t triangles() const;
  std::uint64_t rays() const;  ///< cast so far
  /// Of triangles and the hierarchy over them.
  std::uint64_t memory_bytes() const;

 private:
  struct Geometry;
  struct Impl;
  explicit ExactReference(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnomon::metrics
