// A stack without arrays: STACK_SIZE floats that move by one place at a push and at a pop. One copy of
// the tree. Depends on node_pair.glsl.

struct Stack {
  vec4 a;
  vec4 b;
  vec4 c;
  vec4 d;
  vec4 e;
  vec4 f;
  vec4 g;
  vec4 h;
};

Stack pushed(Stack stack, float entry) {
  stack.h = vec4(stack.g.w, stack.h.x, stack.h.y, stack.h.z);
  stack.g = vec4(stack.f.w, stack.g.x, stack.g.y, stack.g.z);
  stack.f = vec4(stack.e.w, stack.f.x, stack.f.y, stack.f.z);
  stack.e = vec4(stack.d.w, stack.e.x, stack.e.y, stack.e.z);
  stack.d = vec4(stack.c.w, stack.d.x, stack.d.y, stack.d.z);
  stack.c = vec4(stack.b.w, stack.c.x, stack.c.y, stack.c.z);
  stack.b = vec4(stack.a.w, stack.b.x, stack.b.y, stack.b.z);
  stack.a = vec4(entry, stack.a.x, stack.a.y, stack.a.z);
  return stack;
}

Stack popped(Stack stack) {
  stack.a = vec4(stack.a.y, stack.a.z, stack.a.w, stack.b.x);
  stack.b = vec4(stack.b.y, stack.b.z, stack.b.w, stack.c.x);
  stack.c = vec4(stack.c.y, stack.c.z, stack.c.w, stack.d.x);
  stack.d = vec4(stack.d.y, stack.d.z, stack.d.w, stack.e.x);
  stack.e = vec4(stack.e.y, stack.e.z, stack.e.w, stack.f.x);
  stack.f = vec4(stack.f.y, stack.f.z, stack.f.w, stack.g.x);
  stack.g = vec4(stack.g.y, stack.g.z, stack.g.w, stack.h.x);
  stack.h = vec4(stack.h.y, stack.h.z, stack.h.w, 0.0);
  return stack;
}

struct Walk {
  GridRay ray;
  vec2 texel_step;  // a uniform that is read inside a loop is read again at each turn
  float next;       // a pair of nodes to test; or a leaf, or 0 at the end, as in `link`
  Stack waiting;    // more of these
  float link;
};

Walk startWalk(vec3 origin, vec3 direction, bool wanted) {
  vec4 none = vec4(0.0);
  return Walk(rayOnGrid(origin, direction), uNodesStep, wanted ? ROOT_PAIR : 0.0,
              Stack(none, none, none, none, none, none, none, none), 1.0);
}

void walkToLeaf(inout Walk walk, float t) {
  for (int i = 0; i < MAX_STEPS; i++) {
    walk.link = walk.next;
    if (walk.next <= 0.0) {
      walk.next = walk.waiting.a.x;
      walk.waiting = popped(walk.waiting);
      break;
    }
    PairHit pair = meetPair(walk.next, walk.texel_step, walk.ray, t);
    walk.next = pair.any ? pair.nearer : walk.waiting.a.x;
    if (pair.both) walk.waiting = pushed(walk.waiting, pair.farther);
    if (!pair.any) walk.waiting = popped(walk.waiting);
  }
}
