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
  const Vec3 arm = start_.position - start_.target;
  yaw_ = 0;
  pitch_ = std::atan2(glm::dot(arm, up_), glm::dot(arm, front_));
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
  const float start = glm::distance(start_.position, start_.target);
  distance_ =
      std::clamp(distance_ * std::exp(-kZoomStep * steps), kClosest * start, kFarthest * start);
  place();
}

void OrbitCamera::place() {
  const Vec3 level = std::cos(yaw_) * front_ + std::sin(yaw_) * side_;
  const Vec3 arm = std::cos(pitch_) * level + std::sin(pitch_) * up_;
  camera_.position = camera_.target + distance_ * arm;
  // A parallel picture grows with the distance, and what a lens shows sharp moves with the target.
  const float start = glm::distance(start_.position, start_.target);
  camera_.orthographic_height = start_.orthographic_height * (distance_ / start);
  camera_.focus_distance = start_.focus_distance * (distance_ / start);
}

}  // namespace glimt
