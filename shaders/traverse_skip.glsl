// Skip links in one order, the same for all rays: the tree is stored once. The least memory and the
// simplest code, but the farther child often comes first. Depends on skip_walk.glsl and box.glsl.

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  return walkFrom(0.0, origin, direction, wanted);
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
