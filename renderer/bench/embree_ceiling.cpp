#include "renderer/bench/embree_ceiling.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace glimt {
namespace {

// Rays that a thread takes at a time: enough to make the counter cheap, few enough that no thread
// is left with a long rest.
constexpr std::size_t kChunk = 1024;

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
        if (rays.live(i)) results[i] = query(Vec3(rays.origins[i]), Vec3(rays.directions[i]));
    }
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) others.emplace_back(work);
  work();
  others.clear();  // waits for them
  return results;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

// The clock starts before the scene is built and is read after.
EmbreeCeiling::EmbreeCeiling(const Scene& scene)
    : build_seconds_(now()), scene_(scene, RTC_SCENE_FLAG_NONE) {
  build_seconds_ = now() - build_seconds_;
}

std::vector<float> EmbreeCeiling::closestHits(const Rays& rays) const {
  return castAll(rays, [this](const Vec3& origin, const Vec3& direction) {
    const auto hit = scene_.closestHit(origin, direction);
    return hit ? hit->t : -1.0f;
  });
}

std::vector<float> EmbreeCeiling::visibilities(const Rays& rays) const {
  return castAll(rays, [this](const Vec3& origin, const Vec3& direction) {
    return scene_.occluded(origin, direction) ? 0.0f : 1.0f;
  });
}

}  // namespace glimt
