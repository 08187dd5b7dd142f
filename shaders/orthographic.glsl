// A parallel projection: rays start on the picture, which is in the plane of the camera, and
// uCameraRight and uCameraUp reach to its edges there.
CameraRay parallelRay(vec2 at) {
  return CameraRay(uCameraPosition + cameraPoint(at) - uCameraForward, uCameraForward);
}
