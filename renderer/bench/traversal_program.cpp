#include "renderer/bench/traversal_program.h"

#include "renderer/bench/stopwatch.h"
#include "renderer/shader/composer.h"

namespace glimt {
namespace {

constexpr const char* kRays = R"(
uniform sampler2D uOrigins;
uniform sampler2D uDirections;
uniform vec2 uRayStep;

vec3 rayOrigin() { return texture2D(uOrigins, pixelCenter() * uRayStep).xyz; }
vec3 rayDirection() { return texture2D(uDirections, pixelCenter() * uRayStep).xyz; }
)";

constexpr const char* kClosestHit = R"(
void main() {
  vec3 direction = rayDirection();
  Hit hit = closestHit(rayOrigin(), direction, dot(direction, direction) > 0.0);
  bool found = hit.triangle < TRIANGLE_UNKNOWN;
  TriangleData data = fetchTriangle(found ? hit.triangle : 0.0);
  vec3 normal = normalize(cross(data.v1 - data.v0, data.v2 - data.v0));
  writeTexel(vec4(normal, found ? hit.t : (hit.triangle == TRIANGLE_NONE ? -1.0 : -2.0)));
})";

constexpr const char* kVisibility = R"(
void main() {
  vec3 direction = rayDirection();
  float seen = visibility(rayOrigin(), direction, 1.0, dot(direction, direction) > 0.0);
  writeTexel(vec4(0.0, 0.0, 0.0, seen));
})";

}  // namespace

RayTextures::RayTextures(const gl::Device& device, const Rays& rays, int side)
    : origins_(gl::Texture::floats(device.gl(), device.floatForm(), side, side, rays.origins)),
      directions_(
          gl::Texture::floats(device.gl(), device.floatForm(), side, side, rays.directions)),
      target_(gl::Texture::floats(device.gl(), device.floatForm(), side, side)) {}

void RayTextures::bind(gl::Program& program) const {
  program.set("uOrigins", origins_);
  program.set("uDirections", directions_);
  program.set("uRayStep", Vec2(1.0f / static_cast<float>(side())));
}

TraversalProgram::TraversalProgram(const gl::Device& device, const std::string& traversal,
                                   Question question)
    : device_(&device) {
  const std::string main = question == Question::visibility ? kVisibility : kClosestHit;
  compile_seconds_ = secondsOf(device, [&] {
    program_.emplace(device.gl(), "traversal " + traversal, composeVertexShader(),
                     composeTraversalProbe(traversal, kRays + main));
  });
}

double TraversalProgram::run(const SceneTextures& scene, const RayTextures& rays) {
  prepare(scene, rays);
  return secondsOf(*device_, [&] { device_->draw({0, 0, rays.side(), rays.side()}); });
}

double TraversalProgram::compileSeconds(const SceneTextures& scene, const RayTextures& rays) {
  prepare(scene, rays);
  return compile_seconds_ + secondsOf(*device_, [&] { device_->draw({0, 0, 1, 1}); });
}

void TraversalProgram::prepare(const SceneTextures& scene, const RayTextures& rays) {
  program_->use();
  program_->set("uZero", Vec4(0));
  scene.bind(*program_);
  rays.bind(*program_);
  rays.target().bind();
}

std::vector<Vec4> readResults(const RayTextures& rays) {
  return rays.target().readFloats();
}

}  // namespace glimt
