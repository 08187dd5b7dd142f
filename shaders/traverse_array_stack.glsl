// A stack as one would write it: an array that is indexed at run time, which Appendix A of ES 2.0's
// language does not promise. Mesa's softpipe reads wrong values from it, and walks in circles. Depends
// on node_pair.glsl.

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float next;       // a pair of nodes to test; or a leaf, or 0 at the end, as in `link`
  float waiting[STACK_SIZE + 1];  // more of these, above an end that stays
  int top;
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  Walk walk;
  walk.ray = rayOnGrid(origin, direction);
  walk.texel_step = uNodesStep;
  walk.next = wanted ? ROOT_PAIR : 0.0;
  walk.waiting[0] = 0.0;
  walk.top = 0;
  walk.link = 1.0;
  return walk;
}

float popped(inout Walk walk) {
  float entry = walk.waiting[walk.top];
  walk.top = max(walk.top - 1, 0);
  return entry;
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    walk.link = walk.next;
    if (walk.next <= 0.0) {
      walk.next = popped(walk);
      break;
    }
    PairHit pair = meetPair(walk.next, walk.texel_step, walk.ray, t);
    if (pair.both) {
      walk.top++;
      walk.waiting[walk.top] = pair.farther;
    }
    if (pair.any) {
      walk.next = pair.nearer;
    } else {
      walk.next = popped(walk);
    }
  }
}
