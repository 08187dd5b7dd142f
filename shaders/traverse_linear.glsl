// No tree: every triangle is tested. What the others are measured against, and for a handful of
// triangles not the worst.
uniform float uTriangleCount;

Hit closestHit(vec3 origin, vec3 direction, bool wanted) {
  Hit hit = Hit(TRIANGLE_NONE, FAR_AWAY, vec3(1.0), 0.0, 1.0);
  float count = wanted ? uTriangleCount : 0.0;
  float index = 0.0;
  for (int i = 0; i < MAX_STEPS; i++) {
    if (index >= count) break;
    TriangleData data = fetchTriangle(index);
    TriangleHit met = intersectTriangle(origin, direction, data.v0, data.v1, data.v2, hit.t);
    float ordered = met.t * orderOf(met.volumes);
    bool in_the_way = isInTheWay(met.t) && ordered < hit.t;
#if ALPHA
    in_the_way = stopsPath(data, index, met, in_the_way);
#endif
    if (in_the_way) hit = Hit(index, ordered, met.volumes, data.material, data.area);
    index += 1.0;
  }
  if (index < count) hit.triangle = TRIANGLE_UNKNOWN;
  return hit;
}

// The share of light that passes between the origin and `far` times the direction from there: 1 where
// nothing is in its way, 0 where something is, negative where the traversal was cut short.
float visibility(vec3 origin, vec3 direction, float far, bool wanted) {
  float count = wanted ? uTriangleCount : 0.0;
  float index = 0.0;
  bool blocked = false;
  float passed = 1.0;
  for (int i = 0; i < MAX_STEPS; i++) {
    if (index >= count || blocked) break;
    TriangleData data = fetchTriangle(index);
    TriangleHit met = intersectTriangle(origin, direction, data.v0, data.v1, data.v2, far);
    blocked = met.t >= 0.0;
#if ALPHA
    passed *= shareThatPasses(data, index, met, blocked);
    blocked = passed <= 0.0;
#endif
    index += 1.0;
  }
  if (blocked) return 0.0;
  return index >= count ? passed : -1.0;
}
