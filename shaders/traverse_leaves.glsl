// Closest hit and visibility by any of the trees' traversals: walk to a leaf, look at its triangles,
// walk on. Two loops one after the other inside a third are faster than one loop with a branch,
// where rays run in lockstep.

Hit closestHit(vec3 origin, vec3 direction, bool wanted) {
  Walk walk = startWalk(origin, direction, wanted);
  Hit hit = Hit(TRIANGLE_NONE, FAR_AWAY, vec3(1.0), 0.0, 1.0);
  for (int i = 0; i < MAX_STEPS; i++) {
    walkToLeaf(walk, hit.t);
    if (walk.link >= 0.0) break;
    float index = -1.0 - walk.link;
    for (int k = 0; k < MAX_STEPS; k++) {
      TriangleData data = fetchTriangle(index);
      TriangleHit met = intersectTriangle(origin, direction, data.v0, data.v1, data.v2, hit.t);
      float ordered = met.t * orderOf(met.volumes);
      bool in_the_way = isInTheWay(met.t) && ordered < hit.t;
#if ALPHA
      in_the_way = stopsPath(data, index, met, in_the_way);
#endif
      if (in_the_way) hit = Hit(index, ordered, met.volumes, data.material, data.area);
      if (data.last) break;
      index += 1.0;
    }
  }
  if (walk.link != 0.0) hit.triangle = TRIANGLE_UNKNOWN;
  return hit;
}

// The share of light that passes between the origin and `far` times the direction from there: 1 where
// nothing is in its way, 0 where something is, negative where the traversal was cut short.
float visibility(vec3 origin, vec3 direction, float far, bool wanted) {
  Walk walk = startWalk(origin, direction, wanted);
  bool blocked = false;
  float passed = 1.0;
  for (int i = 0; i < MAX_STEPS; i++) {
    walkToLeaf(walk, far);
    if (walk.link >= 0.0) break;
    float index = -1.0 - walk.link;
    for (int k = 0; k < MAX_STEPS; k++) {
      TriangleData data = fetchTriangle(index);
      TriangleHit met = intersectTriangle(origin, direction, data.v0, data.v1, data.v2, far);
      blocked = met.t >= 0.0;
#if ALPHA
      passed *= shareThatPasses(data, index, met, blocked);
      blocked = passed <= 0.0;
#endif
      if (blocked || data.last) break;
      index += 1.0;
    }
    if (blocked) break;
  }
  if (blocked) return 0.0;
  return walk.link == 0.0 ? passed : -1.0;
}
