// The camera, and the pinhole. The vectors span the picture at distance one; uCameraRight and
// uCameraUp reach from its centre to its edges.
uniform vec3 uCameraPosition;
uniform vec3 uCameraForward;
uniform vec3 uCameraRight;
uniform vec3 uCameraUp;

struct CameraRay {
  vec3 origin;
  vec3 direction;  // unit
};

// From the camera to a point of the picture. `at` is in pixels, from its lower left corner.
vec3 cameraPoint(vec2 at) {
  vec2 p = 2.0 * pictureAddress(at) - 1.0;
  return uCameraForward + p.x * uCameraRight + p.y * uCameraUp;
}

CameraRay pinholeRay(vec2 at) {
  return CameraRay(uCameraPosition, normalize(cameraPoint(at)));
}
