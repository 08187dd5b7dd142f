// One tree order per ray octant: no stack, no restart, no bit operations. Depends on skip_walk.glsl.
//
// The tree is stored eight times, once for each combination of the direction's signs, with the child
// that the ray meets first in front. Since the order knows the signs, so do the boxes: they are
// stored as the corner where the ray enters and the corner where it leaves.

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  vec3 negative = 1.0 - step(vec3(0.0), direction);
  float octant = dot(negative, vec3(1.0, 2.0, 4.0));
  return walkFrom(octant * uNodesPerCopy, origin, direction, wanted);
}

bool meetsBox(vec4 node, GridRay ray, float t) {
  Corners planes = distancesTo(node.xyz, ray);
  return isMet(passageOf(planes.first, planes.second, t));
}
