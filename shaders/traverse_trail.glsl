// The restart trail of Laine 2010, "Restart Trail for Stackless BVH Traversal": one bit a level says
// whether the nearer child is done with; what is left is found by going down again from the root.
// Depends on node_pair.glsl, and on trail_float.glsl or trail_bits.glsl.

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // a pair of nodes to test; 0 at the end; negative where a child is done with
  Trail trail;
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  return Walk(rayOnGrid(origin, direction), uNodesStep, wanted ? ROOT_PAIR : 0.0, startTrail(),
              1.0);
}

void restart(inout Walk walk) {
  markChildDone(walk.trail);
  walk.trail.level = ROOT_LEVEL;
  walk.node = isOver(walk.trail) ? 0.0 : ROOT_PAIR;
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    if (walk.node < 0.0) restart(walk);
    walk.link = walk.node;
    if (walk.node == 0.0) break;
    PairHit pair = meetPair(walk.node, walk.texel_step, walk.ray, t);
    TrailStep turn = followTrail(pair, walk.trail);
    walk.node = turn.next;
    if (turn.leaf) {
      walk.link = turn.next;
      break;
    }
  }
}
