// The two children of a node, which are neighbours: one step tests both. Depends on box.glsl.

struct PairHit {
  float nearer;   // links; with one child met, `nearer` is its own
  float farther;
  bool any;       // children met before t
  bool both;
};

float enterDistance(vec4 node, GridRay ray, float t) {
  Passage passage = passageThrough(node.xyz, ray, t);
  return isMet(passage) ? passage.enter : FAR_AWAY;
}

PairHit meetPair(float first, vec2 texel_step, GridRay ray, float t) {
  vec2 at = texelAddress(first, texel_step);
  vec4 lower = texture2D(uNodes, at);
  vec4 upper = texture2D(uNodes, at + texel_step);
  float to_lower = enterDistance(lower, ray, t);
  float to_upper = enterDistance(upper, ray, t);
  bool lower_first = to_lower <= to_upper;
  return PairHit(lower_first ? lower.w : upper.w, lower_first ? upper.w : lower.w,
                 min(to_lower, to_upper) < FAR_AWAY, max(to_lower, to_upper) < FAR_AWAY);
}
