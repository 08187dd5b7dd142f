// One step along a trail: which child of a pair comes next. Depends on node_pair.glsl, and on
// trail_float.glsl or trail_bits.glsl.

struct TrailStep {
  float next;    // a pair, a leaf or the end, as in `link`; -1 where no child is left
  bool leaf;     // or the end
  bool waiting;  // the farther child is met too, and is left for later
};

// Leaves the trail at the level of the next pair; where no child is left, or the next is a leaf, at the
// level where that is a child.
TrailStep followTrail(PairHit pair, inout Trail trail) {
  bool nearer_done = nearerDone(trail);
  // With one child met where the trail says that one is done with, that one is it.
  bool go = pair.any && (pair.both || trail.level != trail.popped);
  // A child without a sibling leaves nothing to come back to.
  if (go && !pair.both && !nearer_done) markNearerDone(trail);
  float next = go ? (pair.both && nearer_done ? pair.farther : pair.nearer) : -1.0;
  bool leaf = go && next <= 0.0;
  if (!leaf) trail.level = go ? levelBelow(trail.level) : levelAbove(trail.level);
  return TrailStep(next, leaf, pair.both && !nearer_done);
}
