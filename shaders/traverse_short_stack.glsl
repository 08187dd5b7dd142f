// A stack of four entries that forgets the oldest, and the restart trail for when it is empty (Laine
// 2010). A vector, since some drivers read wrong values from arrays that are indexed at run time, and
// it is as fast. Depends on trail_step.glsl.

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // a pair of nodes to test; 0 at the end; negative where a child is done with
  Trail trail;
  vec4 waiting;     // pairs and leaves, the last first; 0 where there is none
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  return Walk(rayOnGrid(origin, direction), uNodesStep, wanted ? ROOT_PAIR : 0.0, startTrail(),
              vec4(0.0), 1.0);
}

// What the trail says is next: the farther child at the level that it was last changed at. It is on the
// stack, or else found by going down again from the root.
void popOrRestart(inout Walk walk) {
  markChildDone(walk.trail);
  if (walk.waiting.x != 0.0) {
    walk.node = walk.waiting.x;
    walk.waiting = vec4(walk.waiting.yzw, 0.0);
    walk.trail.level = walk.node > 0.0 ? levelBelow(walk.trail.popped) : walk.trail.popped;
  } else {
    walk.node = isOver(walk.trail) ? 0.0 : ROOT_PAIR;
    walk.trail.level = ROOT_LEVEL;
  }
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    if (walk.node < 0.0) popOrRestart(walk);
    walk.link = walk.node;
    if (walk.node <= 0.0) break;
    PairHit pair = meetPair(walk.node, walk.texel_step, walk.ray, t);
    TrailStep turn = followTrail(pair, walk.trail);
    if (turn.waiting) walk.waiting = vec4(pair.farther, walk.waiting.xyz);
    walk.node = turn.next;
    if (turn.leaf) {
      walk.link = turn.next;
      break;
    }
  }
}
