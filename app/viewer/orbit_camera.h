// A camera that is turned around its target by hand.
#pragma once

#include "renderer/core/bounds.h"
#include "renderer/scene/camera.h"

namespace glimt {

// The same view with a target that it makes sense to turn around: files often name a mere direction
// ahead of the camera. A target outside the model's box moves along the view to the depth of the
// box's centre, if the centre is in front of the camera.
Camera withTargetAtModel(const Camera& camera, const Bounds& model);

// What of a camera does not depend on where it is; see Camera.
struct Lens {
  float vertical_fov = 0;  // degrees
  float aperture_radius = 0;
  float focus_distance = 0;
};

// Turns about `up` of the camera that it starts with. Drags are in picture heights, to the right
// and downwards, and the picture follows them.
class OrbitCamera {
 public:
  // The camera is away from its target and does not look along its up.
  explicit OrbitCamera(const Camera& start);

  const Camera& camera() const { return camera_; }

  // A picture's height is half a turn. Ends just short of the poles.
  void orbit(Vec2 drag);

  // Moves camera and target; what is as far away as the target follows the drag exactly.
  void pan(Vec2 drag);

  // Each step goes the same part of the way to the target, so never through it.
  void zoom(float steps);

  // The same about any point, which stays where it is in the picture.
  void zoomTowards(const Vec3& point, float steps);

  // Turns to the point, which is what is turned around and what a lens shows sharp from then on.
  void lookAt(const Vec3& point);

  // Moves along its view until the box fills a picture of that aspect, width / height.
  void frame(const Bounds& box, float aspect);

  // Where the camera is stays.
  void setLens(const Lens& lens);

  // Back to the start, bit for bit.
  void reset();

 private:
  void place();
  void takeArm();
  float scaleFor(float steps) const;

  Camera start_;
  Camera camera_;
  // Where the camera is, seen from the target: angles in radians about the axes, and metres.
  Vec3 up_{0};
  Vec3 front_{0};
  Vec3 side_{0};
  float yaw_ = 0;
  float pitch_ = 0;
  float distance_ = 1;
  float steepest_ = 0;
};

}  // namespace glimt
