// Ray against a box whose corners are in no order: the distance at which the ray enters it, or
// FAR_AWAY where the box is missed or begins behind t.
float boxDistance(vec3 packed_corners, GridRay ray, float t) {
  Corners box = unpackCorners(packed_corners);
  vec3 t0 = box.first * ray.inverse + ray.offset;
  vec3 t1 = box.second * ray.inverse + ray.offset;
  vec3 near = min(t0, t1);
  vec3 far = max(t0, t1);
  float enter = max(max(near.x, near.y), max(near.z, 0.0));
  float leave = min(min(far.x, far.y), min(far.z, t)) * BOX_SLACK;
  return enter <= leave ? enter : FAR_AWAY;
}
