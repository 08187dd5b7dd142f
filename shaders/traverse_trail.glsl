// The restart trail of Laine 2010, "Restart Trail for Stackless BVH Traversal": one bit a level says
// whether the nearer child is done with; what is left is found by going down again from the root.
// The bits are those of a whole number in a float, the root's the highest. Depends on node_pair.glsl.

#define ROOT_LEVEL 8388608.0

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float node;       // a pair of nodes to test; 0 at the end; negative at a leaf that is done with
  float level;      // the bit of that pair
  float trail;
  float pop_level;  // where the trail was last changed: the nearer child is done with there
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  return Walk(rayOnGrid(origin, direction), uNodesStep, wanted ? ROOT_PAIR : 0.0, ROOT_LEVEL, 0.0,
              0.0, 1.0);
}

bool isOdd(float whole) {
  return whole != 2.0 * floor(0.5 * whole);
}

// Notes that the subtree at this level is done with, and goes back to the root, or to the end.
void restart(inout Walk walk) {
  float level = 2.0 * walk.level;
  float bits = floor(walk.trail / level) + 1.0;
  walk.trail = bits * level;
  for (int i = 0; i < TRAIL_SIZE; i++) {
    if (isOdd(bits)) break;
    bits *= 0.5;
    level *= 2.0;
  }
  walk.pop_level = level;
  walk.node = level > ROOT_LEVEL ? 0.0 : ROOT_PAIR;
  walk.level = ROOT_LEVEL;
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    if (walk.node < 0.0) restart(walk);
    walk.link = walk.node;
    if (walk.node == 0.0) break;
    PairHit pair = meetPair(walk.node, walk.texel_step, walk.ray, t);
    bool nearer_done = isOdd(floor(walk.trail / walk.level));
    // With one child left where the trail says that one is done with, that one is it.
    bool go = pair.any && (pair.both || walk.level != walk.pop_level);
    // A child without a sibling leaves nothing to come back to.
    if (go && !pair.both && !nearer_done) walk.trail += walk.level;
    float child = pair.both && nearer_done ? pair.farther : pair.nearer;
    float next = go ? child : -1.0;
    walk.node = next;
    walk.level *= go ? 0.5 : 1.0;
    if (go && next <= 0.0) {
      walk.link = next;
      break;
    }
  }
}
