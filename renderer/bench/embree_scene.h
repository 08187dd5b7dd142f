// Embree's answers, to compare with.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "renderer/scene/scene.h"

namespace glimt {

struct MeshHit {
  std::uint32_t triangle;  // into Scene::triangles
  float t;                 // in lengths of the direction
};

class EmbreeScene {
 public:
  // `flags`: RTC_SCENE_FLAG_NONE is Embree at its fastest, RTC_SCENE_FLAG_ROBUST without cracks.
  EmbreeScene(const Scene& scene, RTCSceneFlags flags);

  std::optional<MeshHit> closestHit(const Vec3& origin, const Vec3& direction) const;

  // Whether anything is between the origin and the origin plus the direction.
  bool occluded(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

// Inline, so that a ceiling measured through them is not lowered by calls.
inline RTCRay makeEmbreeRay(const Vec3& origin, const Vec3& direction, float far) {
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

inline std::optional<MeshHit> EmbreeScene::closestHit(const Vec3& origin,
                                                      const Vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = makeEmbreeRay(origin, direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return MeshHit{query.hit.primID, query.ray.tfar};
}

inline bool EmbreeScene::occluded(const Vec3& origin, const Vec3& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = makeEmbreeRay(origin, direction, 1);
  rtcOccluded1(scene_.get(), &context, &ray);
  return ray.tfar < 0;
}

}  // namespace glimt
