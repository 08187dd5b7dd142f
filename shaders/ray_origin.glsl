// Where a ray that leaves a surface starts.

// What the rounding errors of a triangle's points are in proportion to, in metres: its largest
// coordinate, or more where the two edges at vertex 0 are so nearly parallel that their cross product,
// and with it the distance of a point from the plane, is inexact. Of a sliver whose vertex 0 is across
// from its longest edge they are not, unless it is so obtuse that nothing else is left.
float errorScale(vec3 v0, vec3 v1, vec3 v2) {
  vec3 largest = max(abs(v0), max(abs(v1), abs(v2)));
  vec3 a = v1 - v0;
  vec3 b = v2 - v0;
  vec3 c = v2 - v1;
  float longest2 = max(dot(a, a), max(dot(b, b), dot(c, c)));
  vec3 normal = cross(a, b);
  float product = sqrt(dot(a, a) * dot(b, b));
  float cancelled = product / max(sqrt(dot(normal, normal)), 1.0e-6 * product);
  float inexact = 0.08 * cancelled * sqrt(longest2);
  return max(inexact, max(largest.x, max(largest.y, largest.z)));
}

// A point rebuilt from barycentric weights is off its triangle by some roundings of that scale, and
// so is the distance at which a ray meets the triangle again. 2^-20 is sixteen of them.
const float LEAVE_DISTANCE = 9.5367431640625e-7;

// `normal` is unit and points to the side on which the ray goes on.
vec3 leaveSurface(vec3 point, vec3 normal, float error_scale) {
  return point + normal * (error_scale * LEAVE_DISTANCE);
}

// Barycentric weights of a point that rays can leave. Where two faces meet at an acute angle, a ray
// that starts beside their edge and above the one face may start behind the other: not when it is
// sixteen times as far from the edge as from the face, and the angle is above 3.6 degrees. No point
// is moved by more than some 64 times that distance from the face, or a tenth of the triangle: thin
// triangles leave less room.
vec2 awayFromEdges(vec3 v0, vec3 v1, vec3 v2, vec2 uv, float error_scale) {
  vec3 a = v1 - v0;
  vec3 b = v2 - v0;
  vec3 c = v2 - v1;
  vec3 normal = cross(a, b);
  vec3 lengths = sqrt(vec3(dot(c, c), dot(b, b), dot(a, a)));
  float leave = LEAVE_DISTANCE * error_scale;
  float inner = 16.0 * leave / max(sqrt(dot(normal, normal)), 1.0e-30);
  float longest = max(lengths.x, max(lengths.y, lengths.z));
  float most = min(64.0 * leave / max(longest, 1.0e-30), 0.1);
  vec3 weights = vec3(1.0 - uv.x - uv.y, uv);
  weights = max(weights, min(inner * lengths, vec3(most)));
  return vec2(weights.y, weights.z) / (weights.x + weights.y + weights.z);
}
