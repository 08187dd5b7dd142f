// Embree's answers, to compare with.
#pragma once

#include <embree3/rtcore.h>

#include <cstdint>
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

}  // namespace glimt
