// The trail's bits in an integer, which ES 2.0 has not. The root's bit is the highest: what is carried
// beyond it is lost, and leaves 0.

#define ROOT_LEVEL 0x80000000u

struct Trail {
  uint bits;
  uint level;   // the bit of the pair that is tested
  uint popped;  // the lowest bit that is set: there the nearer child is done with
};

Trail startTrail() {
  return Trail(0u, ROOT_LEVEL, 0u);
}

uint levelBelow(uint level) {
  return level >> 1;
}

uint levelAbove(uint level) {
  return level << 1;
}

bool nearerDone(Trail trail) {
  return (trail.bits & trail.level) != 0u;
}

void markNearerDone(inout Trail trail) {
  trail.bits |= trail.level;
}

// Adds one at the level, with what is carried up from there, and forgets the bits below.
void markChildDone(inout Trail trail) {
  trail.bits = (trail.bits & (~trail.level + 1u)) + trail.level;
  trail.popped = trail.bits & (~trail.bits + 1u);
}

// The root itself is done with.
bool isOver(Trail trail) {
  return trail.bits == 0u;
}
