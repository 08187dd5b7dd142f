#include "renderer/bench/embree_scene.h"

#include <cstring>
#include <limits>

namespace glimt {
namespace {

RTCRay makeRay(const Vec3& origin, const Vec3& direction, float far) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tfar = far;
  ray.mask = 0xffffffffu;
  return ray;
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, RTCSceneFlags flags)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
  rtcSetSceneFlags(scene_.get(), flags);
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), scene.positions.size()));
  std::memcpy(positions, scene.positions.data(), scene.positions.size() * sizeof(Vec3));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), scene.triangles.size()));
  for (const Triangle& triangle : scene.triangles)
    for (const std::uint32_t index : triangle.positions) *corners++ = index;
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_.get());
}

std::optional<MeshHit> EmbreeScene::closestHit(const Vec3& origin, const Vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = makeRay(origin, direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return MeshHit{query.hit.primID, query.ray.tfar};
}

bool EmbreeScene::occluded(const Vec3& origin, const Vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = makeRay(origin, direction, 1);
  rtcOccluded1(scene_.get(), &context, &ray);
  return ray.tfar < 0;
}

}  // namespace glimt
