// Skip links in one order, the same for all rays: the tree is stored once, depth first. The least
// memory and the simplest code, but the farther child often comes first.
uniform float uNodesPerCopy;  // with the one at the end

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // the next to visit
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  return Walk(rayOnGrid(origin, direction), uNodesStep, wanted ? 0.0 : uNodesPerCopy - 1.0, 1.0);
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    vec4 node = texture2D(uNodes, texelAddress(walk.node, walk.texel_step));
    bool met = isMet(passageThrough(node.xyz, walk.ray, t));
    walk.link = node.w;
    walk.node = met || node.w < 0.0 ? walk.node + 1.0 : node.w;
    if (node.w == 0.0 || (met && node.w < 0.0)) break;
  }
}
