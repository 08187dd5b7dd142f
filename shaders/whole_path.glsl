// A whole path in one shader, its state in local variables instead of hit records: what one pass per
// bounce is measured against. It calls the functions that the passes call, but no ray looks for light
// after the last surface. The caller repeats meetSurface and scatterPath, in a loop or written out.

struct Path {
  PathRay ray;
  HitRecord record;  // where the ray has come to
  bool ended;
  vec3 radiance;  // found so far
};

Path startPath(PathRay ray) {
  HitRecord nowhere = HitRecord(TRIANGLE_NONE, 0.0, vec2(0.0), ray.direction, vec3(0.0), 0.0);
  return Path(ray, nowhere, false, vec3(0.0));
}

// Follows the ray, and adds the light found where it ends. `first`: the ray is the camera's, which
// no light sample competes with.
void meetSurface(inout Path path, vec4 random, bool first, bool last) {
  Hit hit = followRay(path.ray);
  path.record = recordOf(path.ray, hit, first ? 1.0 : emissionWeight(path.ray, hit, false));
  vec3 throughput = path.record.throughput;
  float largest = max(throughput.r, max(throughput.g, throughput.b));
  path.ended = !goesOn(path.ray, hit) || !(largest >= LEAST_THROUGHPUT);
  path.radiance += radianceOf(path.record, path.ended, random, last ? 1.0 : 0.0);
#if ENVIRONMENT
  bool escaped = !path.ended && path.record.triangle == TRIANGLE_NONE;
  if (escaped) path.radiance += escapedRadiance(path.record);
#endif
}

void scatterPath(inout Path path, vec4 random) {
  path.ray = scatteredRay(path.record, path.ended, random);
}
