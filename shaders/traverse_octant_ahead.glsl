// Two nodes a step: the next one and, while its texel is on the way, the one behind it, which is where
// the walk goes on whenever the first is met or is a leaf. On a CPU the second costs little, since a
// step mostly waits for the first. Depends on octant_nodes.glsl.

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    vec2 at = texelAddress(walk.node, walk.texel_step);
    vec4 first = texture2D(uNodes, at);
    vec4 second = texture2D(uNodes, at + walk.texel_step);
    bool met_first = meetsBox(first, walk.ray, t);
    bool met_second = meetsBox(second, walk.ray, t);
    bool in_order = met_first || first.w < 0.0;
    bool found = first.w == 0.0 || (met_first && first.w < 0.0);
    bool both = in_order && !found;
    float behind = walk.node + 1.0;
    float behind_second = met_second || second.w < 0.0 ? walk.node + 2.0 : second.w;
    walk.link = both ? second.w : first.w;
    walk.node = both ? behind_second : (in_order ? behind : first.w);
    if (found || (both && (second.w == 0.0 || (met_second && second.w < 0.0)))) break;
  }
}
