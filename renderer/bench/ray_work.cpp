#include "renderer/bench/ray_work.h"

#include "renderer/shader/composer.h"
#include "renderer/shader/traversals.h"

namespace glimt {
namespace {

// Nodes, texels of triangles, boxes, triangles.
constexpr const char* kCounters = R"(
vec4 counted = vec4(0.0);

vec4 countedFetch(vec4 kind, sampler2D texels, vec2 at) {
  counted += kind;
  return texture2D(texels, at);
}
)";

constexpr const char* kCountTriangleTests = R"(
TriangleHit countedTriangle(vec3 origin, vec3 direction, vec3 v0, vec3 v1, vec3 v2, float far) {
  counted.w += 1.0;
  return intersectTriangle(origin, direction, v0, v1, v2, far);
}
#define intersectTriangle countedTriangle
)";

constexpr const char* kCountTriangleFetches = R"(
#undef texture2D
#define texture2D(texels, at) countedFetch(vec4(0.0, 1.0, 0.0, 0.0), texels, at)
)";

constexpr const char* kCountNodeFetches = R"(
#undef texture2D
#define texture2D(texels, at) countedFetch(vec4(1.0, 0.0, 0.0, 0.0), texels, at)
)";

constexpr const char* kCountBoxTests = R"(
bool countedBox(Passage passage) {
  counted.z += 1.0;
  return isMet(passage);
}
#define isMet countedBox
)";

// Each macro stands behind the file that defines what it replaces, or before the first that
// fetches.
std::vector<Insertion> counting() {
  return {{"prelude.glsl", kCounters},
          {"triangle.glsl", kCountTriangleTests},
          {"texel_address.glsl", kCountTriangleFetches},
          {"triangle_data.glsl", kCountNodeFetches},
          {"box.glsl", kCountBoxTests}};
}

// The results are part of what is written, so that nothing is left out.
constexpr const char* kClosestHit = R"(
void main() {
  vec3 direction = rayDirection();
  Hit hit = closestHit(rayOrigin(), direction, dot(direction, direction) > 0.0);
  writeTexel(hit.triangle < 0.0 ? vec4(0.0) : counted);
})";

constexpr const char* kVisibility = R"(
void main() {
  vec3 direction = rayDirection();
  float seen = visibility(rayOrigin(), direction, 1.0, dot(direction, direction) > 0.0);
  writeTexel(seen > 1.0 ? vec4(0.0) : counted);
})";

std::string countingShader(const std::string& traversal, TraversalProgram::Question question) {
  const bool visibility = question == TraversalProgram::Question::visibility;
  return composeTraversalProbe(
      traversal,
      std::string("#undef texture2D\n") +
          (traversalNamed(traversal).gles < 3 ? "" : "#define texture2D texture\n") +
          rayTexturesText() + (visibility ? kVisibility : kClosestHit),
      counting());
}

}  // namespace

std::vector<RayWork> countRayWork(const gl::Device& device, const std::string& traversal,
                                  TraversalProgram::Question question, const SceneTextures& scene,
                                  const RayTextures& rays) {
  TraversalProgram(device, "counting traversal " + traversal, countingShader(traversal, question),
                   traversalNamed(traversal).gles)
      .run(scene, rays);
  std::vector<RayWork> works;
  for (const Vec4& counted : readResults(rays))
    works.push_back({counted.x, counted.y, counted.z, counted.w});
  return works;
}

}  // namespace glimt
