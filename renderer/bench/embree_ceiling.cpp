#include "renderer/bench/embree_ceiling.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>
#include <limits>
#include <thread>

namespace glimt {
namespace {

// Rays that a thread takes at a time: enough to make the counter cheap, few enough that no thread
// is left with a long rest.
constexpr std::size_t kChunk = 1024;

RTCRay makeRay(const Vec4& origin, const Vec4& direction, float far) {
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

float closestHit(RTCScene scene, const Vec4& origin, const Vec4& direction) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray = makeRay(origin, direction, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &query);
  return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1.0f : query.ray.tfar;
}

float visibility(RTCScene scene, const Vec4& origin, const Vec4& direction) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = makeRay(origin, direction, 1);
  rtcOccluded1(scene, &context, &ray);
  return ray.tfar < 0 ? 0.0f : 1.0f;
}

template <typename Query>
std::vector<float> castAll(const Rays& rays, const Query& query) {
  std::vector<float> results(rays.size(), -1.0f);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (;;) {
      const std::size_t begin = next.fetch_add(kChunk);
      if (begin >= rays.size()) return;
      const std::size_t end = std::min(begin + kChunk, rays.size());
      for (std::size_t i = begin; i < end; ++i)
        if (rays.live(i)) results[i] = query(rays.origins[i], rays.directions[i]);
    }
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) others.emplace_back(work);
  work();
  others.clear();  // waits for them
  return results;
}

void attachTriangles(RTCDevice device, RTCScene target, const Scene& scene) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* const positions = rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), scene.positions.size());
  std::memcpy(positions, scene.positions.data(), scene.positions.size() * sizeof(Vec3));
  auto* corners = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), scene.triangles.size()));
  for (const Triangle& triangle : scene.triangles)
    corners = std::copy(triangle.positions.begin(), triangle.positions.end(), corners);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(target, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace

class EmbreeCeiling::State {
 public:
  explicit State(const Scene& source) : device_(rtcNewDevice(nullptr)) {
    scene_ = rtcNewScene(device_);
    const auto start = std::chrono::steady_clock::now();
    attachTriangles(device_, scene_, source);
    rtcCommitScene(scene_);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  RTCScene scene() const { return scene_; }
  double seconds() const { return seconds_; }

 private:
  RTCDevice device_;
  RTCScene scene_;
  double seconds_ = 0;
};

EmbreeCeiling::EmbreeCeiling(const Scene& scene) : state_(std::make_unique<State>(scene)) {}
EmbreeCeiling::EmbreeCeiling(EmbreeCeiling&&) noexcept = default;
EmbreeCeiling::~EmbreeCeiling() = default;

double EmbreeCeiling::buildSeconds() const {
  return state_->seconds();
}

std::vector<float> EmbreeCeiling::closestHits(const Rays& rays) const {
  return castAll(rays, [this](const Vec4& origin, const Vec4& direction) {
    return closestHit(state_->scene(), origin, direction);
  });
}

std::vector<float> EmbreeCeiling::visibilities(const Rays& rays) const {
  return castAll(rays, [this](const Vec4& origin, const Vec4& direction) {
    return visibility(state_->scene(), origin, direction);
  });
}

}  // namespace glimt
