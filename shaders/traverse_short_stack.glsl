// A stack of a few entries that forgets the oldest, and the restart trail for when it is empty (Laine
// 2010, section 4). Depends on trail_step.glsl.

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // a pair of nodes to test; 0 at the end; negative where a child is done with
  Trail trail;
  float waiting[SHORT_STACK_SIZE];  // in a ring
  int top;                          // of the last entry
  int count;
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  Walk walk;
  walk.ray = rayOnGrid(origin, direction);
  walk.texel_step = uNodesStep;
  walk.node = wanted ? ROOT_PAIR : 0.0;
  walk.trail = startTrail();
  walk.top = 0;
  walk.count = 0;
  walk.link = 1.0;
  return walk;
}

void push(inout Walk walk, float entry) {
  walk.top = (walk.top + 1) & (SHORT_STACK_SIZE - 1);
  walk.waiting[walk.top] = entry;
  walk.count = min(walk.count + 1, SHORT_STACK_SIZE);
}

// What the trail says is next: the farther child at the level that it was last changed at. It is on the
// stack, or else found by going down again from the root.
void popOrRestart(inout Walk walk) {
  markChildDone(walk.trail);
  if (walk.count > 0) {
    walk.node = walk.waiting[walk.top];
    walk.top = (walk.top - 1) & (SHORT_STACK_SIZE - 1);
    walk.count--;
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
    if (turn.waiting) push(walk, pair.farther);
    walk.node = turn.next;
    if (turn.leaf) {
      walk.link = turn.next;
      break;
    }
  }
}
