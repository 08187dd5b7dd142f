#include "app/viewer/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glimt {
namespace {

// At the pole itself nothing says which way is up in the picture.
constexpr float kSteepest = 89.0f * std::numbers::pi_v<float> / 180;

constexpr float kZoomStep = 0.15f;

// Closest and farthest, in units of the distance at the start.
constexpr float kClosest = 1e-3f;
constexpr float kFarthest = 1e3f;

bool contains(const Bounds& box, const Vec3& point) {
  return glm::all(glm::greaterThanEqual(point, box.min)) &&
         glm::all(glm::lessThanEqual(point, box.max));
}

}  // namespace

Camera withTargetAtModel(const Camera& camera, const Bounds& model) {
  if (model.empty() || contains(model, camera.target)) return camera;
  const Vec3 forward = glm::normalize(camera.target - camera.position);
  const float depth = glm::dot(model.center() - camera.position, forward);
  if (!(depth > 0)) return camera;
  Camera moved = camera;
  moved.target = camera.position + depth * forward;
  // So close that the two are one in floats: the direction would be lost.
  return glm::distance(moved.target, moved.position) > 0.5f * depth ? moved : camera;
}

OrbitCamera::OrbitCamera(const Camera& start) : start_(start), camera_(start) {
  const Vec3 arm = start.position - start.target;
  up_ = glm::normalize(start.up);
  side_ = glm::normalize(glm::cross(up_, arm));
  front_ = glm::cross(side_, up_);
  reset();
}

void OrbitCamera::reset() {
  camera_ = start_;
  takeArm();
}

void OrbitCamera::takeArm() {
  const Vec3 arm = camera_.position - camera_.target;
  yaw_ = std::atan2(glm::dot(arm, side_), glm::dot(arm, front_));
  pitch_ = std::atan2(glm::dot(arm, up_), glm::length(arm - glm::dot(arm, up_) * up_));
  distance_ = glm::length(arm);
  // A camera that starts above the limit does not jump when it is first touched.
  steepest_ = std::max(kSteepest, std::abs(pitch_));
}

void OrbitCamera::orbit(Vec2 drag) {
  constexpr float turn = 2 * std::numbers::pi_v<float>;
  yaw_ = std::remainder(yaw_ - drag.x * turn / 2, turn);
  pitch_ = std::clamp(pitch_ + drag.y * turn / 2, -steepest_, steepest_);
  place();
}

void OrbitCamera::pan(Vec2 drag) {
  const CameraFrame frame(camera_);
  const bool parallel = camera_.orthographic_height > 0;
  const float height = parallel ? camera_.orthographic_height : 2 * distance_ * frame.half_height;
  const Vec3 shift = height * (drag.y * frame.up - drag.x * frame.right);
  camera_.target += shift;
  camera_.position += shift;
}

void OrbitCamera::zoom(float steps) {
  zoomTowards(camera_.target, steps);
}

// By how much the distance changes.
float OrbitCamera::scaleFor(float steps) const {
  const float start = glm::distance(start_.position, start_.target);
  const float distance =
      std::clamp(distance_ * std::exp(-kZoomStep * steps), kClosest * start, kFarthest * start);
  return distance / distance_;
}

// A parallel picture grows with the distance, and what a lens shows sharp moves with the target.
void OrbitCamera::zoomTowards(const Vec3& point, float steps) {
  const float scale = scaleFor(steps);
  distance_ *= scale;
  camera_.target = point + scale * (camera_.target - point);
  camera_.orthographic_height *= scale;
  camera_.focus_distance *= scale;
  place();
}

void OrbitCamera::lookAt(const Vec3& point) {
  const Vec3 arm = camera_.position - point;
  if (!(glm::length(arm) > 0)) return;
  camera_.target = point;
  takeArm();
  camera_.focus_distance = distance_;
  place();
}

void OrbitCamera::frame(const Bounds& box, float aspect) {
  const float radius = 0.5f * glm::length(box.size());
  if (!(radius > 0)) return;
  const float half_height = CameraFrame(camera_).half_height * std::min(aspect, 1.0f);
  const float distance = radius * std::sqrt(1 + 1 / (half_height * half_height));
  camera_.target = box.center();
  if (camera_.orthographic_height > 0)
    camera_.orthographic_height = 2 * radius / std::min(aspect, 1.0f);
  distance_ = distance;
  camera_.focus_distance = distance;
  place();
}

void OrbitCamera::setLens(const Lens& lens) {
  camera_.vertical_fov = lens.vertical_fov;
  camera_.aperture_radius = lens.aperture_radius;
  camera_.focus_distance = lens.focus_distance;
}

void OrbitCamera::place() {
  const Vec3 level = std::cos(yaw_) * front_ + std::sin(yaw_) * side_;
  const Vec3 arm = std::cos(pitch_) * level + std::sin(pitch_) * up_;
  camera_.position = camera_.target + distance_ * arm;
}

}  // namespace glimt
