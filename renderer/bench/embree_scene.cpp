#include "renderer/bench/embree_scene.h"

#include <cstring>

namespace glimt {

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

}  // namespace glimt
