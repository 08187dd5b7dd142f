// How far two pixels show the same surface, from 0 to 1.

bool isInside(vec2 at) {
  return at.x > 0.0 && at.y > 0.0 && at.x < 1.0 && at.y < 1.0;
}

// Of the depth, relative; beyond what the surface's slope explains.
const float DEPTH_TOLERANCE = 0.005;

// How the depth changes from a pixel to the next on its own surface: the smaller step, since the other
// one may lead over an edge.
vec2 depthSlope(vec2 pixel, float depth) {
  vec4 around;
  around.x = fetchGuide(pictureAddress(pixel + vec2(1.0, 0.0))).depth - depth;
  around.y = fetchGuide(pictureAddress(pixel - vec2(1.0, 0.0))).depth - depth;
  around.z = fetchGuide(pictureAddress(pixel + vec2(0.0, 1.0))).depth - depth;
  around.w = fetchGuide(pictureAddress(pixel - vec2(0.0, 1.0))).depth - depth;
  around = abs(around);
  return vec2(min(around.x, around.y), min(around.z, around.w));
}

float guideWeight(Guide own, Guide other, vec2 slope, vec2 offset) {
  float alike = clamp(dot(own.normal, other.normal) /
                          max(length(own.normal) * length(other.normal), 1.0e-6), 0.0, 1.0);
  float depth = abs(own.depth - other.depth) /
                (dot(slope, abs(offset)) + DEPTH_TOLERANCE * abs(own.depth) + 1.0e-12);
  vec3 color = abs(own.color - other.color) / (own.color + other.color + 2.0 * LEAST_COLOR);
  float colors = max(color.r, max(color.g, color.b));
  float coverage = abs(own.coverage - other.coverage);
  return pow(alike, 64.0) * exp(-depth - 4.0 * colors * colors - 8.0 * coverage);
}
