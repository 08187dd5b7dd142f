// A thin lens: what is at the focus distance is sharp, a point elsewhere becomes a picture of the
// lens. Depends on warp.glsl.
uniform vec3 uLensRight;       // from its centre to its edge
uniform vec3 uLensUp;
uniform float uLensBlades;     // corners; 0: it is round
uniform float uFocusDistance;  // along uCameraForward
uniform vec4 uLensPoint[POINT_GROUPS];  // the sample points of its own set of dimensions
uniform vec4 uLensOffsetsShift;

// Uniform on a regular polygon with a corner at the top: one of its triangles, and a point in that.
vec2 samplePolygon(vec2 random, float corners) {
  float place = random.x * corners;
  float first = min(floor(place), corners - 1.0);
  vec2 weights = sampleTriangle(vec2(place - first, random.y));
  vec2 angles = (vec2(first, first + 1.0) / corners + 0.25) * (2.0 * PI);
  return vec2(dot(weights, cos(angles)), dot(weights, sin(angles)));
}

// From the centre of the lens.
vec3 lensPoint(vec2 pixel) {
  vec4 point =
      ownPoint(pixel, uLensPoint[0], uLensPoint[1], uLensPoint[2], uLensPoint[3]);
  vec2 random = shiftedPoint(pixel, point, uLensOffsetsShift).xy;
  vec2 p = uLensBlades > 2.5 ? samplePolygon(random, uLensBlades) : sampleDisk(random);
  return p.x * uLensRight + p.y * uLensUp;
}

CameraRay lensRay(vec2 pixel, vec2 at) {
  vec3 start = lensPoint(pixel);
  return CameraRay(uCameraPosition + start, normalize(uFocusDistance * cameraPoint(at) - start));
}
