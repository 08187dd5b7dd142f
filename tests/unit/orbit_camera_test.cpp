#include "app/viewer/orbit_camera.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace glimt;

namespace {

Camera start() {
  Camera camera;
  camera.position = {1, 2, 8};
  camera.target = {1, 1, 0};
  camera.vertical_fov = 50;
  return camera;
}

Vec3 arm(const Camera& camera) {
  return camera.position - camera.target;
}

// Degrees above the target.
float elevation(const Camera& camera) {
  return glm::degrees(std::asin(glm::dot(glm::normalize(arm(camera)), glm::normalize(camera.up))));
}

// Where a point appears: the picture's middle is 0, its upper edge 0.5.
Vec2 projected(const Camera& camera, const Vec3& point) {
  const Vec3 forward = glm::normalize(camera.target - camera.position);
  const Vec3 right = glm::normalize(glm::cross(forward, camera.up));
  const Vec3 up = glm::cross(right, forward);
  const Vec3 ray = point - camera.position;
  const float height = 2 * glm::dot(ray, forward) * std::tan(glm::radians(camera.vertical_fov) / 2);
  return Vec2(glm::dot(ray, right), glm::dot(ray, up)) / height;
}

bool same(const Vec3& a, const Vec3& b) {
  return a == b;
}

bool near(const Vec3& a, const Vec3& b) {
  return glm::distance(a, b) < 1e-4f;
}

}  // namespace

TEST_CASE("an untouched orbit is the camera that it was made of, and so is one that was reset") {
  OrbitCamera orbit(start());
  CHECK(same(orbit.camera().position, start().position));
  orbit.orbit({0.3f, -0.2f});
  orbit.pan({0.1f, 0.7f});
  orbit.zoom(3);
  CHECK_FALSE(near(orbit.camera().position, start().position));
  orbit.reset();
  CHECK(same(orbit.camera().position, start().position));
  CHECK(same(orbit.camera().target, start().target));
  orbit.orbit({0, 0});
  CHECK(near(orbit.camera().position, start().position));
}

TEST_CASE("orbiting keeps target, distance, up and field of view") {
  OrbitCamera orbit(start());
  for (int i = 0; i < 100; ++i) orbit.orbit({0.37f, i % 2 == 0 ? 0.11f : -0.12f});
  CHECK(same(orbit.camera().target, start().target));
  CHECK(same(orbit.camera().up, start().up));
  CHECK(orbit.camera().vertical_fov == start().vertical_fov);
  CHECK(glm::length(arm(orbit.camera())) == Approx(glm::length(arm(start()))));
}

TEST_CASE("what faces the camera follows the drag") {
  OrbitCamera orbit(start());
  const Vec3 facing = start().target + Vec3(0, 0, 1);
  const Vec2 before = projected(orbit.camera(), facing);
  orbit.orbit({0.05f, 0});
  CHECK(projected(orbit.camera(), facing).x > before.x + 0.01f);
  orbit.reset();
  orbit.orbit({0, 0.05f});
  CHECK(projected(orbit.camera(), facing).y < before.y - 0.01f);
}

TEST_CASE("a drag over the picture's height is half a turn") {
  OrbitCamera orbit(start());
  orbit.orbit({1, 0});
  const Vec3 opposite = arm(start()) * Vec3(-1, 1, -1);
  CHECK(near(arm(orbit.camera()), opposite));
  orbit.orbit({1, 0});
  CHECK(near(arm(orbit.camera()), arm(start())));
}

TEST_CASE("orbiting ends just short of the poles and comes back") {
  OrbitCamera orbit(start());
  for (int i = 0; i < 20; ++i) orbit.orbit({0.01f, 0.3f});
  CHECK(elevation(orbit.camera()) == Approx(89).margin(0.05));
  for (int i = 0; i < 20; ++i) orbit.orbit({0.01f, -0.3f});
  CHECK(elevation(orbit.camera()) == Approx(-89).margin(0.05));
}

TEST_CASE("a camera that starts above the limit does not jump") {
  Camera camera = start();
  camera.position = camera.target + Vec3(0, 5, 0.01f);
  OrbitCamera orbit(camera);
  orbit.orbit({0, 0});
  CHECK(near(orbit.camera().position, camera.position));
}

TEST_CASE("orbiting turns about the camera's own up") {
  Camera camera = start();
  camera.up = {0, 0, 2};
  camera.position = camera.target + Vec3(3, 1, 1);
  OrbitCamera orbit(camera);
  orbit.orbit({0.25f, 0});
  CHECK(orbit.camera().position.z == Approx(camera.position.z));
  CHECK(elevation(orbit.camera()) == Approx(elevation(camera)).margin(0.01));
}

TEST_CASE("panning moves the picture by just the drag and keeps the view's direction") {
  OrbitCamera orbit(start());
  orbit.zoom(-4);
  orbit.orbit({0.2f, 0.1f});
  const Vec3 target = orbit.camera().target;
  const Vec3 before = arm(orbit.camera());
  orbit.pan({0.25f, 0.125f});
  CHECK(projected(orbit.camera(), target).x == Approx(0.25).margin(1e-4));
  CHECK(projected(orbit.camera(), target).y == Approx(-0.125).margin(1e-4));
  CHECK(near(arm(orbit.camera()), before));
}

TEST_CASE("zooming is exponential, has a way back, and never goes through the target") {
  OrbitCamera orbit(start());
  const float distance = glm::length(arm(start()));
  orbit.zoom(1);
  const float step = glm::length(arm(orbit.camera())) / distance;
  CHECK(step < 1);
  orbit.zoom(1);
  CHECK(glm::length(arm(orbit.camera())) == Approx(step * step * distance));
  orbit.zoom(-2);
  CHECK(near(orbit.camera().position, start().position));

  for (int i = 0; i < 1000; ++i) orbit.zoom(5);
  CHECK(glm::length(arm(orbit.camera())) > 0);
  CHECK(glm::dot(arm(orbit.camera()), arm(start())) > 0);
  for (int i = 0; i < 2000; ++i) orbit.zoom(-5);
  CHECK(std::isfinite(glm::length(arm(orbit.camera()))));
}

TEST_CASE("a target that is a mere direction moves into the model, and the view stays") {
  Bounds model;
  model.include(Vec3(-1));
  model.include(Vec3(3, 3, 1));
  Camera camera;
  camera.position = {1, 1, 9};
  camera.target = {1, 1, 8};
  CHECK(near(withTargetAtModel(camera, model).target, {1, 1, 0}));
  CHECK(same(withTargetAtModel(camera, model).position, camera.position));

  SECTION("one that is in the model stays") {
    camera.target = {2, 2, 0.5f};
    CHECK(same(withTargetAtModel(camera, model).target, camera.target));
  }
  SECTION("one stays when the camera looks away from the model") {
    camera.target = {1, 1, 10};
    CHECK(same(withTargetAtModel(camera, model).target, camera.target));
  }
}

TEST_CASE("zooming towards a point leaves it where it is in the picture") {
  OrbitCamera orbit(start());
  const Vec3 point(0.3f, 1.7f, 0.5f);
  const Vec2 before = projected(orbit.camera(), point);
  orbit.zoomTowards(point, 4);
  CHECK(glm::distance(projected(orbit.camera(), point), before) < 1e-4f);
  CHECK(glm::length(arm(orbit.camera())) < glm::length(arm(start())));
}

TEST_CASE("a camera that looks at a point has it in its middle, in focus, and turns around it") {
  Camera lens = start();
  lens.aperture_radius = 0.1f;
  OrbitCamera orbit(lens);
  const Vec3 point(-0.5f, 0.8f, 0.7f);
  orbit.lookAt(point);
  CHECK(near(orbit.camera().position, start().position));
  CHECK(glm::length(projected(orbit.camera(), point)) < 1e-4f);
  CHECK(orbit.camera().focus_distance == Approx(glm::distance(start().position, point)));
  orbit.orbit({0.2f, 0.1f});
  CHECK(glm::length(projected(orbit.camera(), point)) < 1e-4f);
}

TEST_CASE("a framed box is in the picture as a whole, and fills much of it") {
  OrbitCamera orbit(start());
  const Bounds box{{-3, 0, 1}, {5, 2, 4}};
  orbit.frame(box, 1.5f);
  float farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                  (corner & 4) ? box.max.z : box.min.z);
    const Vec2 seen = glm::abs(projected(orbit.camera(), at));
    farthest = std::max({farthest, seen.x / 1.5f, seen.y});
  }
  CHECK(farthest <= 0.5f);
  CHECK(farthest > 0.2f);
}
