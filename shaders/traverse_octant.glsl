// One node a step. Depends on octant_nodes.glsl.

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    vec4 node = texture2D(uNodes, texelAddress(walk.node, walk.texel_step));
    bool met = meetsBox(node, walk.ray, t);
    walk.link = node.w;
    walk.node = met || node.w < 0.0 ? walk.node + 1.0 : node.w;
    if (node.w == 0.0 || (met && node.w < 0.0)) break;
  }
}
