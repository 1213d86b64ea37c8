// SPDX-License-Identifier: Apache-2.0
// RAII around Embree's handles.
#include "host/metrics/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace gnomon::metrics {
namespace {

void check(RTCDevice device, const char* doing) {
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    throw std::runtime_error(std::string("Embree failed while ") + doing + " (error " +
                             std::to_string(error) + ")");
}

template <class T>
void upload(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::span<const T> data) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), data.size());
  if (buffer == nullptr) throw std::runtime_error("Embree could not allocate a geometry buffer");
  std::memcpy(buffer, data.data(), data.size_bytes());
}

template <class Ray>
void set_ray(Ray& ray, const Vec3& origin, const Vec3& direction) {
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0;
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.time = 0;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
}

}  // namespace

struct RayScene::Impl {
  explicit Impl(const Vec3& c) : center(c) {
    device = rtcNewDevice(nullptr);
    if (device == nullptr) throw std::runtime_error("Embree could not be started");
    rtcSetDeviceMemoryMonitorFunction(device, count_memory, this);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    check(device, "making a scene");
  }
  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  /// Embree calls this from all threads, before it takes memory and after it gave some back.
  static bool count_memory(void* impl, ssize_t bytes, bool) {
    static_cast<Impl*>(impl)->memory += bytes;
    return true;
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Vec3 center;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::atomic<std::int64_t> memory{0};  ///< bytes
};

RayScene::RayScene(const Vec3& center) : impl_(std::make_unique<Impl>(center)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

void RayScene::add(std::span<const std::array<float, 3>> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles) {
  RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  upload(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points);
  upload(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  check(impl_->device, "adding triangles");
}

void RayScene::commit() {
  rtcCommitScene(impl_->scene);
  check(impl_->device, "building its hierarchy");
}

std::optional<RayHit> RayScene::first_hit(const Vec3& origin, const Vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  set_ray(query.ray, origin - impl_->center, direction);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return RayHit{query.ray.tfar, query.hit.geomID, query.hit.primID, query.hit.u, query.hit.v};
}

bool RayScene::any_hit(const Vec3& origin, const Vec3& direction, double reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{};
  set_ray(ray, origin - impl_->center, direction);
  // What single precision cannot hold is as good as infinite.
  if (reach < double{std::numeric_limits<float>::max()}) ray.tfar = static_cast<float>(reach);
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar < 0;
}

std::uint64_t RayScene::memory_bytes() const {
  return static_cast<std::uint64_t>(std::max(std::int64_t{0}, impl_->memory.load()));
}

}  // namespace gnomon::metrics
