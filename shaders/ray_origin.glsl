// Where a ray that leaves a surface starts.

// Largest coordinate of a triangle, by which the rounding error of its points is bounded.
float largestCoordinate(vec3 v0, vec3 v1, vec3 v2) {
  vec3 largest = max(abs(v0), max(abs(v1), abs(v2)));
  return max(largest.x, max(largest.y, largest.z));
}

// A point rebuilt from barycentric weights is off its triangle by some roundings of the largest
// coordinate, and so is the distance at which a ray meets the triangle again. 2^-20 is sixteen of
// them. `normal` is unit and points to the side on which the ray goes on.
vec3 leaveSurface(vec3 point, vec3 normal, float largest_coordinate) {
  return point + normal * (largest_coordinate * 9.5367431640625e-7);
}
