// Skip links, one tree order per ray octant: no stack, no restart, no bit operations.
//
// The tree is stored eight times, once for each combination of the direction's signs, depth first
// and with the child that the ray meets first in front. A box that is met leads to the next node, a
// box that is missed to the node behind its subtree. Since the order knows the signs, so do the
// boxes: they are stored as the corner where the ray enters and the corner where it leaves. Each
// copy ends with a node that counts as a leaf whether it is met or not, so that walking needs one
// test.
uniform float uNodesPerCopy;  // with the one at the end

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // the next to visit
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  vec3 negative = 1.0 - step(vec3(0.0), direction);
  float octant = dot(negative, vec3(1.0, 2.0, 4.0));
  float node = octant * uNodesPerCopy + (wanted ? 0.0 : uNodesPerCopy - 1.0);
  return Walk(rayOnGrid(origin, direction), uNodesStep, node, 1.0);
}

bool meetsBox(vec4 node, GridRay ray, float t) {
  Corners box = distancesTo(node.xyz, ray);
  return isMet(passageOf(box.first, box.second, t));
}
