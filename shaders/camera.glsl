// The pinhole camera. The vectors span the picture at distance one; uCameraRight and uCameraUp reach
// from its centre to its edges.
uniform vec3 uCameraPosition;
uniform vec3 uCameraForward;
uniform vec3 uCameraRight;
uniform vec3 uCameraUp;

// `at` is a point of the picture in pixels, from its lower left corner.
vec3 cameraDirection(vec2 at) {
  vec2 p = 2.0 * pictureAddress(at) - 1.0;
  return normalize(uCameraForward + p.x * uCameraRight + p.y * uCameraUp);
}
