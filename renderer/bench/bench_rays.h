// The rays of a path tracer, one of each kind for every pixel.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/core/vector.h"
#include "renderer/scene/camera.h"

namespace glimt {

// Pixels whose path has ended have direction 0: they keep their place, so that the others stay
// together as in a picture, but nothing is cast and they are not counted.
struct Rays {
  std::vector<Vec4> origins;
  std::vector<Vec4> directions;

  std::size_t size() const { return origins.size(); }
  bool live(std::size_t i) const { return Vec3(directions[i]) != Vec3(0); }
  std::size_t countLive() const;
};

// What a ray meets: the unit normal of the triangle, and the distance, negative for a miss.
using SurfaceHit = Vec4;

// One through a random point of each pixel of a square picture.
Rays makeCameraRays(const Camera& camera, int side);

// Cosine-sampled over the side of the surface from which the camera ray came.
Rays makeBounceRays(const Rays& camera, const std::vector<SurfaceHit>& hits);

// To random points just under the light of the bench's meshes, which is at direction * 1.
Rays makeShadowRays(const Rays& camera, const std::vector<SurfaceHit>& hits);

}  // namespace glimt
