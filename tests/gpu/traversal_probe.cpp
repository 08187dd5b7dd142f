#include "tests/gpu/traversal_probe.h"

#include "renderer/shader/composer.h"

namespace glimt::test {

const std::string kClosestHit = R"(
vec4 probe(vec4 origin, vec4 direction) {
  Hit hit = closestHit(origin.xyz, direction.xyz, true);
  float kind = hit.triangle < TRIANGLE_UNKNOWN ? 1.0 : 0.0;
  if (hit.triangle == TRIANGLE_UNKNOWN) kind = -1.0;
  TriangleData data = fetchTriangle(hit.triangle < TRIANGLE_UNKNOWN ? hit.triangle : 0.0);
  return vec4(kind, data.material, hit.t, weightsOf(hit.volumes).x);
})";

const std::string kVisibility = R"(
vec4 probe(vec4 origin, vec4 direction) {
  return vec4(visibility(origin.xyz, direction.xyz, 1.0, true), 0.0, 0.0, 0.0);
})";

TraversalProbe::TraversalProbe(const gl::Device& device, const std::string& text,
                               const std::string& traversal)
    : probe_(device, composeTraversalProbe(traversal, text + probeMain(2)),
             traversalNamed(traversal).gles) {}

}  // namespace glimt::test
