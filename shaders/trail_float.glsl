// The trail's bits in two floats, for want of integers: those from the root down to level 1 make a whole
// number, those below a fraction. Together they read as one binary number.

#define ROOT_LEVEL 2097152.0

struct Trail {
  float whole;
  float fraction;
  float level;   // the bit of the pair that is tested
  float popped;  // the lowest bit that is set: there the nearer child is done with
};

Trail startTrail() {
  return Trail(0.0, 0.0, ROOT_LEVEL, 0.0);
}

float levelBelow(float level) {
  return 0.5 * level;
}

float levelAbove(float level) {
  return 2.0 * level;
}

bool isOdd(float whole) {
  return whole != 2.0 * floor(0.5 * whole);
}

bool nearerDone(Trail trail) {
  float part = trail.level < 1.0 ? trail.fraction : trail.whole;
  return isOdd(floor(part / trail.level));
}

void markNearerDone(inout Trail trail) {
  bool below = trail.level < 1.0;
  trail.whole += below ? 0.0 : trail.level;
  trail.fraction += below ? trail.level : 0.0;
}

// Adds one at the level, with what is carried up from there, and forgets the bits below.
void markChildDone(inout Trail trail) {
  bool below = trail.level < 1.0;
  float bits = floor((below ? trail.fraction : trail.whole) / trail.level) + 1.0;
  float sum = bits * trail.level;
  bool carried = below && sum == 1.0;
  trail.whole = below ? trail.whole + (carried ? 1.0 : 0.0) : sum;
  trail.fraction = below && !carried ? sum : 0.0;
  bits = carried ? trail.whole : bits;
  trail.popped = carried ? 1.0 : trail.level;
  for (int i = 0; i < TRAIL_SIZE; i++) {
    if (isOdd(bits)) break;
    bits *= 0.5;
    trail.popped *= 2.0;
  }
}

// The root itself is done with.
bool isOver(Trail trail) {
  return trail.popped > ROOT_LEVEL;
}
