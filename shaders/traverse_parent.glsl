// Links to parents: Hapala, Davidovič, Wald, Havran and Slusallek 2011, "Efficient Stack-less BVH
// Traversal for Ray Tracing". A node is reached from its parent, from its sibling or from a child, and
// that alone says where to go on: the nearer child is reached from the parent and followed by the
// farther, which is reached from its sibling and followed by the parent. Depends on box.glsl.

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  vec3 nearer;      // for each axis, the side of the nearer child: -1 the lower, 1 the upper
  float pair;       // 0 at the end
  float side;       // of the node in it, as in `nearer`
  bool from_child;  // the node is done with
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  vec3 nearer = 1.0 - 2.0 * step(vec3(0.0), direction);
  return Walk(rayOnGrid(origin, direction), uNodesStep, nearer, wanted ? ROOT_TRIPLE : 0.0, -1.0,
              false, 1.0);
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    walk.link = 0.0;
    if (walk.pair == 0.0) break;
    vec2 at = texelAddress(walk.pair, walk.texel_step);
    vec4 above = texture2D(uNodes, at);
    vec4 node = texture2D(uNodes, at + walk.side * walk.texel_step);
    walk.link = node.w;
    vec3 axis = 1.0 - step(vec3(0.0), node.xyz);
    bool met = !walk.from_child && isMet(passageThrough(abs(node.xyz), walk.ray, t));
    bool leaf = node.w < 0.0;
    bool down = met && !leaf;
    bool across = !down && walk.side == dot(above.yzw, walk.nearer);
    walk.from_child = !down && !across;
    float side_above = above.x < 0.0 ? -1.0 : 1.0;
    walk.pair = down ? node.w : (across ? walk.pair : abs(above.x));
    walk.side = down ? dot(axis, walk.nearer) : (across ? -walk.side : side_above);
    if (met && leaf) break;
  }
}
